// SPDX-License-Identifier: MIT
#include "models/numeric/plane.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace cigsim {
namespace {

constexpr double kEps = 0x1p-53;  // unit round-off
// Below this magnitude products may have lost bits to underflow, and the filter must not decide.
constexpr double kUnderflow = 0x1p-900;

thread_local std::uint64_t fallbacks = 0;

int sign(const Exact& value) { return sgn(value); }

Exact exact_value(const Plane& plane, const ExactVec& point) {
  return dot(exact_normal(plane), point - convert<Exact>(plane.exact.p));
}

// One component of the normal, a1*b2 - a2*b1 with a, b rounded differences of doubles. Each
// difference carries a relative error of eps, each product 3 eps, the sum one more: within
// 5 eps (|a1 b2| + |a2 b1|) to first order; 6 covers the rest.
double component_error(double a1, double b2, double a2, double b1) {
  const double bound = 6 * kEps * (std::abs(a1 * b2) + std::abs(a2 * b1));
  const bool lost = (a1 != 0 && b2 != 0 && std::abs(a1 * b2) < kUnderflow) ||
                    (a2 != 0 && b1 != 0 && std::abs(a2 * b1) < kUnderflow);
  return lost ? std::numeric_limits<double>::infinity() : bound;
}

// Scenes on a grid (all coordinates whole multiples of 2^-16 and below 2^22) are decided in 128-bit
// whole numbers: differences below 2^40, the normal below 2^81, the value below 2^124.
constexpr double kGrid = 0x1p16, kGridLimit = 0x1p38;

bool to_grid(const Vec3& v, std::int64_t (&out)[3]) {
  const double c[3] = {v.x * kGrid, v.y * kGrid, v.z * kGrid};
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(c[i]) < kGridLimit)) return false;
    out[i] = static_cast<std::int64_t>(c[i]);
    if (static_cast<double>(out[i]) != c[i]) return false;
  }
  return true;
}

// Sign of the value on the grid, or nothing when a point is off the grid.
std::optional<int> grid_side(const PlaneDefinition& d, const Vec3& x) {
  std::int64_t p[3], u0[3], u1[3], v0[3], v1[3], q[3];
  if (!to_grid(x, q) || !to_grid(d.p, p) || !to_grid(d.u0, u0) || !to_grid(d.u1, u1) ||
      !to_grid(d.v0, v0) || !to_grid(d.v1, v1))
    return std::nullopt;
  __int128 sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const __int128 n = static_cast<__int128>(u1[j] - u0[j]) * (v1[k] - v0[k]) -
                       static_cast<__int128>(u1[k] - u0[k]) * (v1[j] - v0[j]);
    sum += n * (q[i] - p[i]);
  }
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

// Value and error bound of n·(x - p). Each term n_i (x_i - p_i) adds eps for the difference, eps
// for the product, 2 eps for the two sums: `error` holds E_i + 5 eps |n_i| for all of that.
struct Filtered {
  double value, bound;
};
Filtered filtered(const Plane& plane, const Vec3& x) {
  const Vec3 d = x - plane.exact.p;
  const double bound =
      std::abs(d.x) * plane.error.x + std::abs(d.y) * plane.error.y + std::abs(d.z) * plane.error.z;
  return {dot(plane.normal, d), bound};
}

// A decision the filter may take, or 0 when it may not (NaN and infinity included).
int decided(double value, double bound) {
  if (value > bound && value > kUnderflow) return 1;
  if (value < -bound && value < -kUnderflow) return -1;
  return 0;
}

// Below the distance of the plane: what is certain of the value over the longest that the exact
// normal can be. Each operation errs by eps; kSlack is more than all of them together.
double distance_below(const Plane& plane, const Filtered& f) {
  constexpr double kSlack = 0x1p-48;
  const double certain = std::abs(f.value) * (1 - kSlack) - f.bound * (1 + kSlack);
  const double x = std::abs(plane.normal.x) + plane.error.x,
               y = std::abs(plane.normal.y) + plane.error.y,
               z = std::abs(plane.normal.z) + plane.error.z;
  const double length = std::sqrt(x * x + y * y + z * z) * (1 + kSlack);
  // Squares that were lost, or none: no clearance.
  if (!(length > 0x1p-400) || !(length < 0x1p400) || !(certain > kUnderflow)) return 0;
  return certain / length * (1 - kSlack);
}

}  // namespace

Plane make_plane(const PlaneDefinition& definition) {
  const Vec3 u = definition.u1 - definition.u0;
  const Vec3 v = definition.v1 - definition.v0;
  Plane plane{definition, cross(u, v), {}};
  const Vec3 e{component_error(u.y, v.z, u.z, v.y), component_error(u.z, v.x, u.x, v.z),
               component_error(u.x, v.y, u.y, v.x)};
  plane.error = {e.x + 5 * kEps * std::abs(plane.normal.x),
                 e.y + 5 * kEps * std::abs(plane.normal.y),
                 e.z + 5 * kEps * std::abs(plane.normal.z)};
  return plane;
}

Plane plane_through(const Vec3& a, const Vec3& b, const Vec3& c) {
  return make_plane({a, a, b, a, c});
}

Plane plane_with_normal(const Vec3& p, const Vec3& n) {
  // Two directions whose cross product is a positive multiple of n.
  const Vec3 zero{};
  if (n.x != 0) {
    const double s = n.x > 0 ? 1 : -1;
    return make_plane({p, zero, {-n.y, n.x, 0}, zero, {-n.z * s, 0, n.x * s}});
  }
  if (n.y != 0) {
    const double s = n.y > 0 ? 1 : -1;
    return make_plane({p, zero, {0, -n.z, n.y}, zero, {n.y * s, 0, 0}});
  }
  return make_plane({p, zero, {n.z, 0, 0}, zero, {0, 1, 0}});
}

Plane axis_plane(int axis, double position) {
  Vec3 p{}, n{};
  (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = position;
  (axis == 0 ? n.x : axis == 1 ? n.y : n.z) = 1;
  return plane_with_normal(p, n);
}

Plane reversed(const Plane& plane) {
  const PlaneDefinition& d = plane.exact;
  return make_plane({d.p, d.v0, d.v1, d.u0, d.u1});
}

ExactVec exact_normal(const Plane& plane) {
  const PlaneDefinition& d = plane.exact;
  return cross(convert<Exact>(d.u1) - convert<Exact>(d.u0),
               convert<Exact>(d.v1) - convert<Exact>(d.v0));
}

int side(const Plane& plane, const Vec3& point) {
  const Filtered f = filtered(plane, point);
  if (const int s = decided(f.value, f.bound)) return s;
  if (const auto s = grid_side(plane.exact, point)) return *s;
  ++fallbacks;
  return sign(exact_value(plane, convert<Exact>(point)));
}

int side(const Plane& plane, const Vec3& point, double& clearance) {
  const Filtered f = filtered(plane, point);
  const int s = decided(f.value, f.bound);
  clearance = s == 0 ? 0 : distance_below(plane, f);
  return s == 0 ? side(plane, point) : s;
}

int side(const Plane& plane, const ExactVec& point) {
  ++fallbacks;
  return sign(exact_value(plane, point));
}

int side(const Plane& plane, const Vec3& rounded, const ExactVec& exact) {
  const Filtered f = filtered(plane, rounded);
  const double slack =
      2 * kEps *
      (std::abs(plane.normal.x * rounded.x) + std::abs(plane.normal.y * rounded.y) +
       std::abs(plane.normal.z * rounded.z));
  if (const int s = decided(f.value, f.bound + slack)) return s;
  ++fallbacks;
  return sign(exact_value(plane, exact));
}

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return side(plane_through(a, b, c), d);
}

bool has_normal(const Plane& plane) {
  const Vec3 &n = plane.normal, &e = plane.error;
  if (std::abs(n.x) > e.x * 2 + kUnderflow || std::abs(n.y) > e.y * 2 + kUnderflow ||
      std::abs(n.z) > e.z * 2 + kUnderflow)
    return true;
  ++fallbacks;
  const ExactVec exact = exact_normal(plane);
  return sgn(exact.x) != 0 || sgn(exact.y) != 0 || sgn(exact.z) != 0;
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return !has_normal(plane_through(a, b, c));
}

std::uint64_t exact_fallbacks() { return fallbacks; }

}  // namespace cigsim
