// SPDX-License-Identifier: MIT
#include "models/database/hull/exact_points.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "models/numeric/expansion.hpp"

namespace cigsim {
namespace {

constexpr double kEps = 0x1p-53;  // unit round-off

// Coordinates from 2^-250 to 1 are multiples of 2^-303, and so are differences; products of three
// differences are multiples of 2^-909, which doubles reach.
constexpr double kSmallestForExpansions = 0x1p-250;

double component(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

double largest_magnitude(std::span<const Vec3> points) {
  double largest = 0;
  bool finite = true;
  for (const Vec3& p : points) {
    finite = finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  if (!finite) throw std::invalid_argument("a coordinate is not a finite number");
  return largest;
}

// One component of a cross product of differences, a1 b2 − a2 b1: the errors of differences,
// products and sum are within 5 eps of the magnitudes to first order; 6 covers the rest.
double component_error(double a1, double b2, double a2, double b1) {
  return 6 * kEps * (std::abs(a1 * b2) + std::abs(a2 * b1));
}

// Bound for each component of n on what one unit of (x − base) adds to the error of the distance,
// its own product and sums included (5 eps; see numeric/plane.cpp).
Vec3 distance_error(const Vec3& u, const Vec3& v, const Vec3& n) {
  return {component_error(u.y, v.z, u.z, v.y) + 5 * kEps * std::abs(n.x),
          component_error(u.z, v.x, u.x, v.z) + 5 * kEps * std::abs(n.y),
          component_error(u.x, v.y, u.y, v.x) + 5 * kEps * std::abs(n.z)};
}

double distance_bound(const Vec3& error, const Vec3& d) {
  const double sum = error.x * std::abs(d.x) + error.y * std::abs(d.y) + error.z * std::abs(d.z);
  return sum * (1 + 8 * kEps) + kUnderflowRoom;
}

using Difference = Expansion<2>;

Expansion<16> minor_of(const Difference& a1, const Difference& b2, const Difference& a2,
                       const Difference& b1) {
  return a1 * b2 - a2 * b1;
}

int rational_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const ExactVec base = convert<Exact>(a);
  return sgn(
      dot(cross(convert<Exact>(b) - base, convert<Exact>(c) - base), convert<Exact>(d) - base));
}

int expansion_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Difference ux = difference(b.x, a.x), uy = difference(b.y, a.y), uz = difference(b.z, a.z);
  const Difference vx = difference(c.x, a.x), vy = difference(c.y, a.y), vz = difference(c.z, a.z);
  const Difference wx = difference(d.x, a.x), wy = difference(d.y, a.y), wz = difference(d.z, a.z);
  return (minor_of(uy, vz, uz, vy) * wx + minor_of(uz, vx, ux, vz) * wy +
          minor_of(ux, vy, uy, vx) * wz)
      .sign();
}

}  // namespace

ExactPoints::ExactPoints(std::span<const Vec3> points) : points_(points) {
  if (points.size() > (std::size_t{1} << 31)) throw std::invalid_argument("more than 2^31 points");
  const double largest = largest_magnitude(points);
  if (largest > 0) std::frexp(largest, &exponent_);
  scaled_.resize(points.size());
  // 2^-exponent may be beyond the doubles; its halves are not.
  const double half = std::ldexp(1.0, -(exponent_ / 2)),
               rest = std::ldexp(1.0, -(exponent_ - exponent_ / 2));
  Vec3 low{1, 1, 1}, high{-1, -1, -1};
  double smallest = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    const Vec3 s{p.x * half * rest, p.y * half * rest, p.z * half * rest};
    scaled_[i] = s;
    low = {std::min(low.x, s.x), std::min(low.y, s.y), std::min(low.z, s.z)};
    high = {std::max(high.x, s.x), std::max(high.y, s.y), std::max(high.z, s.z)};
    for (const auto& [value, original] : {std::pair(s.x, p.x), {s.y, p.y}, {s.z, p.z}})
      if (original != 0) smallest = std::min(smallest, std::abs(value));
  }
  extent_ = (high - low) * (1 + 4 * kEps);
  expansions_ = smallest >= kSmallestForExpansions;
}

FilterPlane ExactPoints::plane(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const Vec3& base = scaled_[a];
  const Vec3 u = scaled_[b] - base, v = scaled_[c] - base, n = cross(u, v);
  return {base, n, distance_bound(distance_error(u, v, n), extent_)};
}

int ExactPoints::exact_side(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                            std::uint32_t d) const {
  if (expansions_) return expansion_side(scaled_[a], scaled_[b], scaled_[c], scaled_[d]);
  return rational_side(points_[a], points_[b], points_[c], points_[d]);
}

int ExactPoints::side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                      std::uint64_t& exact) const {
  const Vec3& base = scaled_[a];
  const Vec3 u = scaled_[b] - base, v = scaled_[c] - base, w = scaled_[d] - base, n = cross(u, v);
  const double value = dot(n, w), bound = distance_bound(distance_error(u, v, n), w);
  if (value > bound) return 1;
  if (value < -bound) return -1;
  ++exact;
  return exact_side(a, b, c, d);
}

int ExactPoints::turn(int axis, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto s = [&](std::uint32_t p, int k) { return component(scaled_[p], k); };
  const double l = (s(b, i) - s(a, i)) * (s(c, j) - s(a, j)),
               r = (s(b, j) - s(a, j)) * (s(c, i) - s(a, i)), value = l - r,
               bound = 6 * kEps * (std::abs(l) + std::abs(r)) + kUnderflowRoom;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  if (expansions_)
    return minor_of(difference(s(b, i), s(a, i)), difference(s(c, j), s(a, j)),
                    difference(s(b, j), s(a, j)), difference(s(c, i), s(a, i)))
        .sign();
  const auto e = [&](std::uint32_t p, int k) { return Exact(component(points_[p], k)); };
  return sgn(
      Exact((e(b, i) - e(a, i)) * (e(c, j) - e(a, j)) - (e(b, j) - e(a, j)) * (e(c, i) - e(a, i))));
}

bool ExactPoints::collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return turn(0, a, b, c) == 0 && turn(1, a, b, c) == 0 && turn(2, a, b, c) == 0;
}

}  // namespace cigsim
