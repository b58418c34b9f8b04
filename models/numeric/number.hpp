// SPDX-License-Identifier: MIT
// The number types a stage can be run on, and the few operations on them that C++ does not give
// for all alike. float and double are the host's; Exact is a rational without rounding (GMP).
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <concepts>

#include "models/numeric/vec3.hpp"

namespace cigsim {

/// A rational number without rounding. A double converts to it exactly.
using Exact = mpq_class;

template <class N>
inline constexpr bool is_exact = std::same_as<N, Exact>;

/// The nearest value of type N to a finite double (exactly that value for double and Exact).
template <class N>
N from_double(double value) {
  return N(value);
}

inline double to_double(float value) { return value; }
inline double to_double(double value) { return value; }
/// Truncates towards zero, as GMP does.
inline double to_double(const Exact& value) { return value.get_d(); }

/// The smallest whole number not below `value`, clamped to [low, high]. NaN gives `low`.
template <std::floating_point N>
int ceil_clamped(N value, int low, int high) {
  const N up = std::ceil(value);
  if (!(up > N(low))) return low;
  if (up >= N(high)) return high;
  return static_cast<int>(up);
}
inline int ceil_clamped(const Exact& value, int low, int high) {
  mpz_class up;
  mpz_cdiv_q(up.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  if (up <= low) return low;
  if (up >= high) return high;
  return static_cast<int>(up.get_si());
}

template <class N>
Vec3T<N> convert(const Vec3& v) {
  return {from_double<N>(v.x), from_double<N>(v.y), from_double<N>(v.z)};
}

template <class N>
Mat3T<N> convert(const Mat3& m) {
  return {{convert<N>(m.row[0]), convert<N>(m.row[1]), convert<N>(m.row[2])}};
}

using ExactVec = Vec3T<Exact>;

}  // namespace cigsim
