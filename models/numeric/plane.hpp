// SPDX-License-Identifier: MIT
// Oriented planes whose side tests are exact.
//
// A plane is defined by doubles alone: a point and two directions, each a difference of two points.
// Its normal (u1 - u0) x (v1 - v0) is therefore an exact polynomial of doubles, although no double
// may hold it. A side test evaluates a rounded normal first and falls back to rational arithmetic
// when the result lies within its error bound (Shewchuk 1997 gives the manner; the bound is derived
// in plane.cpp).
#pragma once

#include <cstdint>
#include <string>

#include "models/numeric/number.hpp"

namespace cigsim {

/// The definition: n = (u1 - u0) x (v1 - v0), and the plane passes through p. Environment units.
struct PlaneDefinition {
  Vec3 p, u0, u1, v0, v1;
  friend bool operator==(const PlaneDefinition&, const PlaneDefinition&) = default;
};

/// A plane with its definition and the rounded normal that the filter uses.
struct Plane {
  PlaneDefinition exact;
  Vec3 normal;  ///< rounded, not of unit length
  Vec3 error;   ///< bound, for each component, on what one unit of (x - p) can add to the error
};

/// The plane of a definition. A zero normal is possible; then every point is on the plane.
Plane make_plane(const PlaneDefinition& definition);

/// The plane through a, b, c with normal (b - a) x (c - a): a face listed anticlockwise as seen
/// from outside has its normal outside.
Plane plane_through(const Vec3& a, const Vec3& b, const Vec3& c);

/// The plane through p with the given normal, exactly. The normal must not be zero.
Plane plane_with_normal(const Vec3& p, const Vec3& normal);

/// The plane x_axis = position (axis 0, 1, 2), normal towards larger coordinates.
Plane axis_plane(int axis, double position);

/// The same plane with its normal turned round.
Plane reversed(const Plane& plane);

/// The exact normal.
ExactVec exact_normal(const Plane& plane);

/// +1 on the normal's side, -1 on the other, 0 exactly on the plane.
int side(const Plane& plane, const Vec3& point);
/// The same, with a clearance: every point of doubles nearer to this one than that is on the same
/// side, strictly. A lower bound on the distance from the plane; 0 where the filter cannot decide.
int side(const Plane& plane, const Vec3& point, double& clearance);
int side(const Plane& plane, const ExactVec& point);

/// Side of the point `exact`, given with a rounding of it that is off by at most one ulp in each
/// coordinate; the filter allows for that.
int side(const Plane& plane, const Vec3& rounded, const ExactVec& exact);

/// Sign of the determinant of (b - a, c - a, d - a): +1 when d lies on the side from which a, b, c
/// run anticlockwise.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// False when the exact normal is zero.
bool has_normal(const Plane& plane);

/// True when a, b, c lie on one line (or coincide), decided exactly.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// How often a side test on this thread went to rational arithmetic since the program began.
std::uint64_t exact_fallbacks();

}  // namespace cigsim
