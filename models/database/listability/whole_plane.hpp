// SPDX-License-Identifier: MIT
// A plane's equation in whole numbers, in which the sides of eyepoints are decided without
// rounding.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "models/numeric/plane.hpp"

namespace cigsim::listability {

using WholeVec = Vec3T<mpz_class>;

/// n . x = d. The value n . x - d is a positive multiple of the plane's own. A plane without a
/// normal (n = 0) has the same value everywhere: every eyepoint is on its TRUE side when d <= 0.
struct WholePlane {
  WholeVec n;
  mpz_class d;
};

/// The equation of a plane, exactly, without common factor.
WholePlane whole_plane(const Plane& plane);
std::vector<WholePlane> whole_planes(const std::vector<Plane>& planes);

inline bool is_zero(const WholeVec& v) { return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0; }

/// The determinant of the three.
inline mpz_class triple(const WholeVec& a, const WholeVec& b, const WholeVec& c) {
  return dot(a, cross(b, c));
}

/// The numbers in doubles, scaled so that the largest is between 1/2 and 1; each is off by at most
/// 2^-51.
std::array<double, 4> scaled(const mpz_class& a, const mpz_class& b, const mpz_class& c,
                             const mpz_class& d);

}  // namespace cigsim::listability
