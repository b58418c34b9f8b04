// SPDX-License-Identifier: MIT
#include "sim/wave/value_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "models/environment/input_error.hpp"

namespace cigsim {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace

ValueNames ValueNames::parse(std::string_view text, const std::string& file) {
  ValueNames result;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.front() == '#') continue;
    const std::size_t blank = line.find_first_of(kBlanks);
    if (blank == std::string_view::npos)
      throw InputError(file, number, fmt::format("the value '{}' has no name", line));
    result.names_.emplace(lower(line.substr(0, blank)), trimmed(line.substr(blank)));
  }
  return result;
}

std::string ValueNames::of(const std::string& value) const {
  const auto found = names_.find(lower(value));
  return found == names_.end() ? value : found->second;
}

}  // namespace cigsim
