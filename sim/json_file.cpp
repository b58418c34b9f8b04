// SPDX-License-Identifier: MIT
#include "sim/json_file.hpp"

#include <optional>
#include <vector>

#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

using Kind = Document::Kind;
using Pointer = nlohmann::ordered_json::json_pointer;

// The entry of a member or an element.
std::optional<std::size_t> child(const Document& document, std::size_t parent,
                                 const std::string& name) {
  const Kind kind = document.entry(parent).kind;
  if (kind != Kind::object && kind != Kind::array) return {};
  std::size_t number = 0;
  for (std::size_t at = parent + 1; document.entry(at).kind != Kind::end; ++number) {
    const std::size_t value = kind == Kind::object ? at + 1 : at;
    const std::string is = kind == Kind::object ? document.text(at) : std::to_string(number);
    if (is == name) return value;
    at = document.after(value);
  }
  return {};
}

}  // namespace

JsonFile::JsonFile(const std::filesystem::path& file) : JsonFile(file, read_whole_file(file)) {}

// What Document takes, the library parses.
JsonFile::JsonFile(const std::filesystem::path& file, const std::string& text)
    : document_(Document::from_json(text, file.string())),
      value_(nlohmann::ordered_json::parse(text)) {}

int JsonFile::line_of(const Pointer& place) const {
  std::vector<std::string> names;
  for (Pointer rest = place; !rest.empty(); rest.pop_back()) names.push_back(rest.back());
  std::size_t at = 0;
  while (!names.empty()) {
    const std::optional<std::size_t> next = child(document_, at, names.back());
    if (!next) break;
    at = *next;
    names.pop_back();
  }
  return static_cast<int>(document_.entry(at).line);
}

}  // namespace cigsim
