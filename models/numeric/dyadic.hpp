// SPDX-License-Identifier: MIT
// What sums and products of doubles make, without rounding: a whole number times a power of two.
// There is no division, and so no common factor to look for. Whole numbers up to 127 bits are
// computed in place, larger ones by GMP: much faster than rationals, most of all on short numbers.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
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
    const std::int64_t mantissa = static_cast<std::int64_t>(std::ldexp(share, 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    short_ = mantissa >> zeros;
    exponent_ += zeros - 53;
  }
  explicit Dyadic(mpz_class whole) : long_(std::move(whole)) {}

  /// −1, 0 or 1.
  int sign() const { return long_ ? sgn(*long_) : short_ > 0 ? 1 : short_ < 0 ? -1 : 0; }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    const int exponent = std::min(a.exponent_, b.exponent_);
    Short x = 0, y = 0, sum = 0;
    if (a.scale(exponent, x) && b.scale(exponent, y) && !__builtin_add_overflow(x, y, &sum))
      return {sum, exponent};
    return {mpz_class(a.whole(exponent) + b.whole(exponent)), exponent};
  }
  friend Dyadic operator-(const Dyadic& a) {
    Short negative = 0;
    if (!a.long_ && !__builtin_sub_overflow(Short{0}, a.short_, &negative))
      return {negative, a.exponent_};
    return {mpz_class(-a.whole(a.exponent_)), a.exponent_};
  }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0 || b.sign() == 0) return {};
    const int exponent = a.exponent_ + b.exponent_;
    Short product = 0;
    if (!a.long_ && !b.long_ && !__builtin_mul_overflow(a.short_, b.short_, &product))
      return {product, exponent};
    return {mpz_class(a.whole(a.exponent_) * b.whole(b.exponent_)), exponent};
  }
  friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }

  /// The power of two that the whole number is multiplied by; of 0, which is a multiple of any,
  /// `other`.
  int exponent_or(int other) const { return sign() == 0 ? other : exponent_; }

  /// The number in units of 2^exponent, of which it must be a multiple.
  mpz_class whole(int exponent) const {
    if (sign() == 0) return {};
    mpz_class out;
    if (long_) {
      out = *long_;
    } else {
      const unsigned __int128 size = short_ < 0 ? -static_cast<unsigned __int128>(short_) : short_;
      const std::uint64_t words[2] = {static_cast<std::uint64_t>(size),
                                      static_cast<std::uint64_t>(size >> 64)};
      mpz_import(out.get_mpz_t(), 2, -1, sizeof words[0], 0, 0, words);
      if (short_ < 0) out = -out;
    }
    return out << static_cast<mp_bitcnt_t>(exponent_ - exponent);
  }

 private:
  using Short = __int128;

  Dyadic(Short whole, int exponent) : short_(whole), exponent_(exponent) {}
  Dyadic(mpz_class whole, int exponent) : long_(std::move(whole)), exponent_(exponent) {}

  // The number in units of 2^exponent, which is not above its own, if that is short.
  bool scale(int exponent, Short& out) const {
    const int up = exponent_ - exponent;
    return !long_ && up < 126 && !__builtin_mul_overflow(short_, Short{1} << up, &out);
  }

  Short short_ = 0;  // the whole number, unless it is long
  std::optional<mpz_class> long_;
  int exponent_ = 0;
};

}  // namespace cigsim
