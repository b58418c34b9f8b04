// SPDX-License-Identifier: MIT
// How sharp the corners of a hull are (Levine 1975, ch. V, step 1a): the faces at a corner cut a
// spherical polygon out of the unit sphere round it, whose area is that of spherical triangles,
// each from its sides by L'Huilier's formula. He cuts the polygon by diagonals; here the triangles
// meet in the direction of the hull's middle, so that the faces may come in any order.
#include <algorithm>
#include <cmath>

#include "models/database/hull/exact_points.hpp"
#include "models/database/sphere/sphere.hpp"

namespace cigsim {
namespace {

// A multiple of v whose largest component is 1, so that products lose nothing; v where it is zero.
Vec3 middling(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest == 0 ? v : Vec3{v.x / largest, v.y / largest, v.z / largest};
}

double angle_between(const Vec3& a, const Vec3& b) {
  const Vec3 n = cross(a, b);
  return std::atan2(std::sqrt(dot(n, n)), dot(a, b));
}

double spherical_area(const Vec3& u, const Vec3& v, const Vec3& w) {
  const double a = angle_between(v, w), b = angle_between(w, u), c = angle_between(u, v);
  const double s = (a + b + c) / 2;
  const double product =
      std::tan(s / 2) * std::tan((s - a) / 2) * std::tan((s - b) / 2) * std::tan((s - c) / 2);
  return 4 * std::atan(std::sqrt(std::max(product, 0.0)));
}

Vec3 middle_of(const ExactPoints& points, const std::vector<std::uint32_t>& corners) {
  Vec3 sum;
  for (const std::uint32_t i : corners) sum = sum + points.scaled(i);
  return sum * (1 / static_cast<double>(corners.size()));
}

std::vector<double> plane_angles(const ExactPoints& points,
                                 const std::vector<std::uint32_t>& polygon) {
  std::vector<double> angles;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& corner = points.scaled(polygon[i]);
    angles.push_back(angle_between(middling(points.scaled(polygon[(i + 1) % n]) - corner),
                                   middling(points.scaled(polygon[(i + n - 1) % n]) - corner)));
  }
  return angles;
}

}  // namespace

std::vector<double> solid_angles(std::span<const Vec3> given, const Hull& hull) {
  const ExactPoints points(given);
  if (hull.dimension == 2) return plane_angles(points, hull.vertices);
  if (hull.dimension < 3) return std::vector<double>(hull.vertices.size(), 0);
  const Vec3 middle = middle_of(points, hull.vertices);
  std::vector<double> by_point(given.size(), 0), angles;
  for (const HullTriangle& t : hull.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& corner = points.scaled(t[i]);
      by_point[t[i]] += spherical_area(middling(points.scaled(t[(i + 1) % 3]) - corner),
                                       middling(points.scaled(t[(i + 2) % 3]) - corner),
                                       middling(middle - corner));
    }
  for (const std::uint32_t i : hull.vertices) angles.push_back(by_point[i]);
  return angles;
}

}  // namespace cigsim
