// SPDX-License-Identifier: MIT
// Sums and products of doubles without rounding, as expansions: unevaluated sums of doubles that do
// not overlap, ascending (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast
// Robust Geometric Predicates"). Many times faster than rationals where few doubles take part.
//
// Exact as long as nothing overflows and no product needs bits below the smallest double: whoever
// uses them keeps magnitudes within bounds and says so.
#pragma once

#include <cmath>
#include <cstddef>

namespace cigsim {

/// At most N doubles, ascending in magnitude, none of them zero; none at all is 0.
template <std::size_t N>
struct Expansion {
  double part[N];
  std::size_t size = 0;

  void push(double value) {
    if (value != 0) part[size++] = value;
  }
  /// −1, 0 or 1: the largest part decides.
  int sign() const { return size == 0 ? 0 : part[size - 1] > 0 ? 1 : -1; }
};

/// high + low = a + b exactly, |a| >= |b| or a = 0.
inline void fast_two_sum(double a, double b, double& high, double& low) {
  high = a + b;
  low = b - (high - a);
}

/// high + low = a + b exactly.
inline void two_sum(double a, double b, double& high, double& low) {
  high = a + b;
  const double b_part = high - a;
  low = (a - (high - b_part)) + (b - b_part);
}

/// A double as the sum of two halves of at most 26 bits (Dekker 1971). |a| below 2^990.
inline void split(double a, double& high, double& low) {
  const double c = 134217729.0 * a;  // 2^27 + 1
  high = c - (c - a);
  low = a - high;
}

/// high + low = a · b exactly.
inline void two_product(double a, double b, double& high, double& low) {
  double a_high, a_low, b_high, b_low;
  high = a * b;
  split(a, a_high, a_low);
  split(b, b_high, b_low);
  low = a_low * b_low - (((high - a_high * b_high) - a_low * b_high) - a_high * b_low);
}

/// a − b.
inline Expansion<2> difference(double a, double b) {
  double high, low;
  two_sum(a, -b, high, low);
  Expansion<2> out;
  out.push(low);
  out.push(high);
  return out;
}

template <std::size_t N>
Expansion<N> operator-(Expansion<N> e) {
  for (std::size_t i = 0; i < e.size; ++i) e.part[i] = -e.part[i];
  return e;
}

template <std::size_t A, std::size_t B>
Expansion<A + B> operator+(const Expansion<A>& a, const Expansion<B>& b) {
  Expansion<A + B> out;
  std::size_t i = 0, j = 0;
  const auto next = [&] {
    if (j == b.size || (i < a.size && std::abs(a.part[i]) < std::abs(b.part[j])))
      return a.part[i++];
    return b.part[j++];
  };
  const std::size_t total = a.size + b.size;
  if (total == 0) return out;
  double sum = next(), low;
  for (std::size_t k = 1; k < total; ++k) {
    two_sum(sum, next(), sum, low);
    out.push(low);
  }
  out.push(sum);
  return out;
}

template <std::size_t A, std::size_t B>
Expansion<A + B> operator-(const Expansion<A>& a, const Expansion<B>& b) {
  return a + -b;
}

template <std::size_t N>
Expansion<2 * N> operator*(const Expansion<N>& e, double factor) {
  Expansion<2 * N> out;
  if (e.size == 0) return out;
  double sum, low;
  two_product(e.part[0], factor, sum, low);
  out.push(low);
  for (std::size_t i = 1; i < e.size; ++i) {
    double high, product_low, middle;
    two_product(e.part[i], factor, high, product_low);
    two_sum(sum, product_low, middle, low);
    out.push(low);
    fast_two_sum(high, middle, sum, low);
    out.push(low);
  }
  out.push(sum);
  return out;
}

template <std::size_t N>
Expansion<4 * N> operator*(const Expansion<N>& e, const Expansion<2>& factor) {
  if (factor.size == 0) return {};
  if (factor.size == 1) {
    const Expansion<2 * N> one = e * factor.part[0];
    Expansion<4 * N> out;
    for (std::size_t i = 0; i < one.size; ++i) out.push(one.part[i]);
    return out;
  }
  return e * factor.part[0] + e * factor.part[1];
}

}  // namespace cigsim
