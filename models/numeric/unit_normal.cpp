// SPDX-License-Identifier: MIT
#include "models/numeric/unit_normal.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

// Share of its largest element that the normal may be off by for doubles to do.
constexpr double kClose = 0x1p-40;

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Divided by its largest element; zero where the plane has no normal.
Vec3 from_exact(const Plane& plane) {
  const ExactVec n = exact_normal(plane);
  Exact most = std::max(Exact(abs(n.x)), Exact(abs(n.y)));
  most = std::max(most, Exact(abs(n.z)));
  if (sgn(most) == 0) return {};
  return {Exact(n.x / most).get_d(), Exact(n.y / most).get_d(), Exact(n.z / most).get_d()};
}

}  // namespace

Vec3 unit_normal(const Plane& plane) {
  const double most = largest(plane.normal);
  // Written so that what is not a number, or has no bound, is not taken for close.
  const bool close = most > 0 && std::isfinite(most) && largest(plane.error) < kClose * most;
  const Vec3 n = close ? Vec3{plane.normal.x / most, plane.normal.y / most, plane.normal.z / most}
                       : from_exact(plane);
  const double length = std::sqrt(dot(n, n));
  if (length == 0) return {};
  return {n.x / length, n.y / length, n.z / length};
}

}  // namespace cigsim
