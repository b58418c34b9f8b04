// SPDX-License-Identifier: MIT
// A double that carries a bound on its own error, for filters: the same formula is evaluated with
// Filtered numbers first, and without rounding only where their sign is in doubt.
//
// The bounds follow running error analysis: a sum adds the bounds of its terms and half an ulp of
// itself, a product each bound times the other's magnitude. Rounding of the bounds themselves is
// covered when the sign is asked for. Values must stay below the largest double.
#pragma once

#include <cmath>

namespace cigsim {

class Filtered {
 public:
  Filtered() = default;
  /// Exactly this double. Implicit, so that formulas written for other numbers take it.
  Filtered(double value) : value_(value) {}
  Filtered(double value, double error) : value_(value), error_(error) {}

  double value() const { return value_; }

  /// −1 or 1; 0: in doubt, or zero.
  int sign() const {
    const double bound = error_ * (1 + 0x1p-30);  // thousands of roundings of the bound
    return value_ > bound ? 1 : value_ < -bound ? -1 : 0;
  }

  friend Filtered operator+(const Filtered& a, const Filtered& b) {
    const double sum = a.value_ + b.value_;
    return {sum, a.error_ + b.error_ + kHalfUlp * std::abs(sum)};
  }
  friend Filtered operator-(const Filtered& a, const Filtered& b) {
    const double difference = a.value_ - b.value_;
    return {difference, a.error_ + b.error_ + kHalfUlp * std::abs(difference)};
  }
  friend Filtered operator*(const Filtered& a, const Filtered& b) {
    const double product = a.value_ * b.value_;
    return {product, std::abs(a.value_) * b.error_ + a.error_ * std::abs(b.value_) +
                         a.error_ * b.error_ + kHalfUlp * std::abs(product) + kUnderflow};
  }

 private:
  static constexpr double kHalfUlp = 0x1p-53;
  static constexpr double kUnderflow = 0x1p-1020;  // what products below the normal doubles lose

  double value_ = 0, error_ = 0;
};

}  // namespace cigsim
