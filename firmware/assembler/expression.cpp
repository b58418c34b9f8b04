// SPDX-License-Identifier: MIT
#include "firmware/assembler/expression.hpp"

#include <stdexcept>

#include "firmware/assembler/text.hpp"

namespace cigsim::firmware {
namespace {

class Parser {
 public:
  Parser(std::string_view text, const Lookup& lookup) : text_(text), lookup_(lookup) {}

  std::int64_t sum() {
    std::int64_t value = 0;
    char sign = '+';
    if (next_is("+-")) sign = text_[at_++];
    for (;;) {
      const std::int64_t term = product();
      value = checked(sign == '-' ? value - term : value + term);
      if (at_ == text_.size()) return value;
      sign = text_[at_++];
    }
  }

 private:
  bool next_is(std::string_view any) const {
    return at_ < text_.size() && any.find(text_[at_]) != std::string_view::npos;
  }

  std::int64_t product() {
    std::int64_t value = operand();
    while (next_is("*/")) {
      const char sign = text_[at_++];
      const std::int64_t right = operand();
      if (sign == '/' && right == 0) fail("divides by zero");
      value = checked(sign == '*' ? value * right : value / right);
    }
    return value;
  }

  std::int64_t operand() {
    const std::size_t end = std::min(text_.find_first_of("+-*/", at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    if (const auto number = to_whole(word)) return checked(*number);
    if (word == "." || is_name(word)) return lookup_(word);
    fail("is no number, name or expression of them");
  }

  // Keeps every product far from overflow.
  std::int64_t checked(std::int64_t value) const {
    constexpr std::int64_t kLimit = std::int64_t{1} << 31;
    if (value > 2 * kLimit || value < -kLimit) fail("is beyond 32 bits");
    return value;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument("'" + std::string(text_) + "' " + what);
  }

  std::string_view text_;
  const Lookup& lookup_;
  std::size_t at_ = 0;
};

}  // namespace

// Products of two values below 2^32 fit: each is checked to lie within -2^31..2^32.
std::int64_t evaluate(std::string_view text, const Lookup& lookup) {
  return Parser(text, lookup).sum();
}

}  // namespace cigsim::firmware
