// SPDX-License-Identifier: MIT
#include "sim/markup.hpp"

#include <cstdint>

namespace cigsim {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

struct Character {
  std::size_t bytes = 1;
  std::uint32_t code = 0;
  bool valid = false;
};

// The first character of `words`, which are not empty. Bytes that begin none are one each.
Character first_character(std::string_view words) {
  const auto byte = [words](std::size_t i) { return static_cast<unsigned char>(words[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {1, lead, true};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || words.size() < bytes) return {};
  std::uint32_t code = lead & (0x7fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0u) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3fu);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kLeast[bytes] || code > 0x10ffff || surrogate) return {};
  return {bytes, code, true};
}

bool is_space(std::uint32_t code) { return code == '\t' || code == '\n' || code == '\r'; }
bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }
bool is_no_character(std::uint32_t code) { return (code & 0xfffe) == 0xfffe; }

}  // namespace

std::string clean_words(std::string_view words) {
  std::string out;
  while (!words.empty()) {
    const Character next = first_character(words);
    if (!next.valid || is_no_character(next.code))
      out += kReplacement;
    else if (is_space(next.code))
      out += ' ';
    else if (!is_control(next.code))
      out += words.substr(0, next.bytes);
    words.remove_prefix(next.bytes);
  }
  return out;
}

std::string markup_escaped(std::string_view words) {
  std::string out;
  for (const char c : clean_words(words)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace cigsim
