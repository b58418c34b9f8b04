// SPDX-License-Identifier: MIT
// Lines and words of format files and microprograms.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cigsim::firmware {

/// The name as messages show it.
inline std::string quoted(std::string_view name) {
  std::string text = "'";
  text += name;
  text += '\'';
  return text;
}

/// The words of a line: what is between spaces and commas, up to a ';'.
inline std::vector<std::string_view> words_of(std::string_view line) {
  line = line.substr(0, line.find(';'));
  constexpr std::string_view kBetween = " \t\r,";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBetween, end);
  }
  return words;
}

/// Calls visit(line number from 1, line) for each line.
template <class Visit>
void for_each_line(std::string_view text, Visit&& visit) {
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    visit(line, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// Letters, digits and '_', not beginning with a digit.
inline bool is_name(std::string_view word) {
  const auto letter = [](char c) {
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  if (word.empty() || !letter(word[0])) return false;
  for (const char c : word)
    if (!letter(c) && !(c >= '0' && c <= '9')) return false;
  return true;
}

/// A whole number from 0 on, decimal or 0x….
inline std::optional<std::int64_t> to_whole(std::string_view word) {
  int base = 10;
  if (word.starts_with("0x") || word.starts_with("0X")) {
    word.remove_prefix(2);
    base = 16;
  }
  std::int64_t value = 0;
  if (word.empty() || word[0] == '-') return {};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return value;
}

}  // namespace cigsim::firmware
