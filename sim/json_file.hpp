// SPDX-License-Identifier: MIT
// A file of JSON, and where in it a value stands.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "models/environment/document.hpp"

namespace cigsim {

class JsonFile {
 public:
  /// Throws InputError, with the line, when it cannot be read, is no JSON or is nested deeper than
  /// anything of ours.
  explicit JsonFile(const std::filesystem::path& file);

  const nlohmann::ordered_json& value() const { return value_; }
  /// The line of the value at `place`, or of what holds it, as far as that exists.
  int line_of(const nlohmann::ordered_json::json_pointer& place) const;

 private:
  explicit JsonFile(const std::filesystem::path& file, const std::string& text);
  Document document_;
  nlohmann::ordered_json value_;
};

}  // namespace cigsim
