// SPDX-License-Identifier: MIT
#include "tests/database/hull/hull_check.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "models/numeric/number.hpp"

namespace cigsim::test {
namespace {

using testing::AssertionFailure;
using testing::AssertionSuccess;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

ExactVec normal_of(std::span<const Vec3> points, const HullTriangle& t) {
  const ExactVec a = convert<Exact>(points[t[0]]);
  return cross(convert<Exact>(points[t[1]]) - a, convert<Exact>(points[t[2]]) - a);
}

bool zero(const ExactVec& v) { return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0; }

testing::AssertionResult is_closed(const std::vector<HullTriangle>& triangles) {
  std::map<Edge, int> edges;
  for (const HullTriangle& t : triangles)
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1)
      return AssertionFailure() << "edge " << edge.first << '-' << edge.second << " is used "
                                << count << " times";
  }
  return AssertionSuccess();
}

testing::AssertionResult holds_all(std::span<const Vec3> points, const HullTriangle& t) {
  const ExactVec n = normal_of(points, t), base = convert<Exact>(points[t[0]]);
  if (zero(n)) return AssertionFailure() << "a triangle without area at " << t[0];
  for (std::size_t i = 0; i < points.size(); ++i)
    if (sgn(dot(n, convert<Exact>(points[i]) - base)) > 0)
      return AssertionFailure() << "point " << i << " is outside triangle " << t[0] << ' ' << t[1]
                                << ' ' << t[2];
  return AssertionSuccess();
}

// Planes through a corner whose normals span space meet in that corner alone.
bool spans_space(const std::vector<ExactVec>& normals) {
  for (std::size_t i = 1; i < normals.size(); ++i) {
    const ExactVec across = cross(normals[0], normals[i]);
    if (zero(across)) continue;
    return std::any_of(normals.begin(), normals.end(),
                       [&](const ExactVec& n) { return sgn(dot(across, n)) != 0; });
  }
  return false;
}

}  // namespace

int rational_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const ExactVec base = convert<Exact>(a);
  return sgn(
      dot(cross(convert<Exact>(b) - base, convert<Exact>(c) - base), convert<Exact>(d) - base));
}

testing::AssertionResult is_hull(std::span<const Vec3> points, const Hull& hull) {
  if (hull.dimension != 3) return AssertionFailure() << "dimension " << hull.dimension;
  if (hull.triangles.size() != 2 * hull.vertices.size() - 4)
    return AssertionFailure() << hull.triangles.size() << " triangles for " << hull.vertices.size()
                              << " vertices";
  if (const auto closed = is_closed(hull.triangles); !closed) return closed;
  std::map<std::uint32_t, std::vector<ExactVec>> normals;
  for (const HullTriangle& t : hull.triangles) {
    if (const auto all = holds_all(points, t); !all) return all;
    for (const std::uint32_t corner : t) normals[corner].push_back(normal_of(points, t));
  }
  if (normals.size() != hull.vertices.size())
    return AssertionFailure() << normals.size() << " corners, " << hull.vertices.size()
                              << " vertices";
  for (const std::uint32_t v : hull.vertices)
    if (!spans_space(normals[v])) return AssertionFailure() << "vertex " << v << " is not extreme";
  return AssertionSuccess();
}

std::vector<Vec3> corner_points(std::span<const Vec3> points, const Hull& hull) {
  std::vector<Vec3> out;
  for (const std::uint32_t v : hull.vertices) out.push_back(points[v]);
  std::sort(out.begin(), out.end(), [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  return out;
}

testing::AssertionResult same_hull(std::span<const Vec3> points, const Hull& a, const Hull& b) {
  if (a.dimension != b.dimension)
    return AssertionFailure() << "dimensions " << a.dimension << " and " << b.dimension;
  if (corner_points(points, a) != corner_points(points, b))
    return AssertionFailure() << a.vertices.size() << " and " << b.vertices.size()
                              << " vertices, not the same";
  return AssertionSuccess();
}

}  // namespace cigsim::test
