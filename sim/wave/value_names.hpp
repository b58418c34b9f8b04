// SPDX-License-Identifier: MIT
// Names of a signal's values, such as states and microinstructions: GTKWave's translate filter
// files.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace cigsim {

class ValueNames {
 public:
  /// A line a value: the value as it would be shown, in the signal's radix, and its name, up to the
  /// end of the line. Lines that begin with # are comments. `file` is for messages. Throws
  /// InputError for a value without a name.
  static ValueNames parse(std::string_view text, const std::string& file);

  /// The name of the value that would be shown as `value`, or `value` if it has none. Letters of
  /// both cases are alike.
  std::string of(const std::string& value) const;

  std::size_t size() const { return names_.size(); }

 private:
  std::map<std::string, std::string> names_;
};

}  // namespace cigsim
