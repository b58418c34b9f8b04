// SPDX-License-Identifier: MIT
// What sums and products of doubles make, without rounding: a whole number times a power of two
// (GMP). There is no division, and so no common factor to look for: many times faster than
// rationals.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cigsim {

class Dyadic {
 public:
  Dyadic() = default;
  /// Exactly this double, which must be finite. Implicit, so that formulas written for other
  /// numbers take it.
  Dyadic(double value) {
    if (value == 0) return;
    const double share = std::frexp(value, &exponent_);
    mantissa_ = static_cast<long>(std::ldexp(share, 53));
    exponent_ -= 53;
    const mp_bitcnt_t zeros = mpz_scan1(mantissa_.get_mpz_t(), 0);
    mantissa_ >>= zeros;
    exponent_ += static_cast<int>(zeros);
  }
  explicit Dyadic(mpz_class whole) : mantissa_(std::move(whole)) {}

  /// −1, 0 or 1.
  int sign() const { return sgn(mantissa_); }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    const int exponent = std::min(a.exponent_, b.exponent_);
    return {a.whole(exponent) + b.whole(exponent), exponent};
  }
  friend Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0 || b.sign() == 0) return {};
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }

  /// The power of two that the mantissa is multiplied by; 0 counts as a multiple of any.
  int exponent_or(int other) const { return sign() == 0 ? other : exponent_; }
  /// The number in units of 2^exponent, of which it must be a multiple.
  mpz_class whole(int exponent) const {
    return sign() == 0 ? mpz_class()
                       : mpz_class(mantissa_ << static_cast<mp_bitcnt_t>(exponent_ - exponent));
  }

 private:
  Dyadic(mpz_class mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  mpz_class mantissa_;
  int exponent_ = 0;
};

}  // namespace cigsim
