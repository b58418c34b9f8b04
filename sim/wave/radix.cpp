// SPDX-License-Identifier: MIT
#include "sim/wave/radix.hpp"

#include <algorithm>
#include <vector>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

// The value of bits without x and z.
unsigned value_of(std::string_view bits) {
  unsigned value = 0;
  for (const char c : bits) value = 2 * value + (c == '1' ? 1 : 0);
  return value;
}

bool known(std::string_view bits) { return bits.find_first_not_of("01") == std::string_view::npos; }

char digit_text(std::string_view bits) {
  if (known(bits)) return "0123456789abcdef"[value_of(bits)];
  return bits.find_first_not_of('z') == std::string_view::npos ? 'z' : 'x';
}

// `bits` to a digit.
std::string grouped(std::string_view digits, std::size_t bits) {
  std::string text;
  std::size_t first = (digits.size() - 1) % bits + 1;
  for (; !digits.empty(); first = bits) {
    text += digit_text(digits.substr(0, first));
    digits.remove_prefix(first);
  }
  return text;
}

// Decimal digits doubled bit after bit, so that no width is too large.
std::string decimal(std::string_view bits) {
  std::vector<int> digits{0};  // the lowest first
  for (const char bit : bits) {
    int carry = bit == '1' ? 1 : 0;
    for (int& digit : digits) {
      digit = 2 * digit + carry;
      carry = digit / 10;
      digit %= 10;
    }
    if (carry != 0) digits.push_back(carry);
  }
  std::string text;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit)
    text += static_cast<char>('0' + *digit);
  return text;
}

// Two's complement.
std::string negated(std::string_view bits) {
  std::string text(bits);
  const std::size_t lowest = text.rfind('1');
  for (std::size_t i = 0; lowest != std::string::npos && i < lowest; ++i)
    text[i] = text[i] == '1' ? '0' : '1';
  return text;
}

std::string characters(std::string_view bits) {
  std::string text;
  std::size_t first = (bits.size() - 1) % 8 + 1;
  for (; !bits.empty(); first = 8) {
    const std::string_view byte = bits.substr(0, first);
    const unsigned value = known(byte) ? value_of(byte) : '?';
    if (value != 0) text += value >= ' ' && value <= '~' ? static_cast<char>(value) : '.';
    bits.remove_prefix(first);
  }
  return text;
}

}  // namespace

Radix parse_radix(std::string_view what, std::string_view text) {
  return parse_choice<Radix>(what, text,
                             {{"bin", Radix::kBinary},
                              {"oct", Radix::kOctal},
                              {"hex", Radix::kHexadecimal},
                              {"dec", Radix::kDecimal},
                              {"signed", Radix::kSigned},
                              {"text", Radix::kText}});
}

std::string value_text(std::string_view digits, Radix radix) {
  if (digits.empty()) return "";
  switch (radix) {
    case Radix::kBinary:
      return std::string(digits);
    case Radix::kOctal:
      return grouped(digits, 3);
    case Radix::kHexadecimal:
      return grouped(digits, 4);
    case Radix::kText:
      return characters(digits);
    case Radix::kDecimal:
    case Radix::kSigned:
      break;
  }
  if (!known(digits)) return digits.find_first_not_of('z') == std::string_view::npos ? "z" : "x";
  const bool negative = radix == Radix::kSigned && digits.front() == '1';
  std::string text(negative ? 1 : 0, '-');
  return text.append(decimal(negative ? negated(digits) : std::string(digits)));
}

}  // namespace cigsim
