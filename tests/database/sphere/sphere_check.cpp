// SPDX-License-Identifier: MIT
#include "tests/database/sphere/sphere_check.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace cigsim::test {
namespace {

using testing::AssertionFailure;
using testing::AssertionSuccess;
using Row = std::vector<Exact>;

// Solves a square system by elimination; nothing when it is singular.
std::optional<Row> solve(std::vector<Row> m) {
  const std::size_t n = m.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    while (pivot < n && sgn(m[pivot][i]) == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(m[i], m[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == i) continue;
      const Exact factor = m[r][i] / m[i][i];
      for (std::size_t c = i; c <= n; ++c) m[r][c] -= factor * m[i][c];
    }
  }
  Row x;
  for (std::size_t i = 0; i < n; ++i) x.push_back(m[i][n] / m[i][i]);
  return x;
}

// Weights of the centre in the frame of the support's edges e: 2 e_i · Σ w_j e_j = e_i · e_i.
std::optional<Row> weights(const std::vector<ExactVec>& edges) {
  std::vector<Row> system;
  for (const ExactVec& a : edges) {
    Row row;
    for (const ExactVec& b : edges) row.push_back(2 * dot(a, b));
    row.push_back(dot(a, a));
    system.push_back(row);
  }
  return solve(system);
}

}  // namespace

testing::AssertionResult is_smallest_sphere(std::span<const Vec3> points,
                                            const BoundingSphere& sphere) {
  if (sphere.support.empty() || sphere.support.size() > 4)
    return AssertionFailure() << sphere.support.size() << " support points";
  const ExactVec base = convert<Exact>(points[sphere.support[0]]);
  std::vector<ExactVec> edges;
  for (std::size_t i = 1; i < sphere.support.size(); ++i)
    edges.push_back(convert<Exact>(points[sphere.support[i]]) - base);
  const auto w = weights(edges);
  if (!w) return AssertionFailure() << "the support is not independent";
  Exact rest = 1;
  ExactVec centre = base;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (sgn((*w)[i]) < 0) return AssertionFailure() << "weight " << i + 1 << " is negative";
    rest -= (*w)[i];
    centre = centre + edges[i] * (*w)[i];
  }
  if (sgn(rest) < 0) return AssertionFailure() << "weight 0 is negative";
  const ExactVec arm = base - centre, rounded = convert<Exact>(sphere.centre);
  const Exact squared = dot(arm, arm), radius(sphere.radius);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ExactVec p = convert<Exact>(points[i]), d = p - centre, given = p - rounded;
    if (dot(d, d) > squared) return AssertionFailure() << "point " << i << " is outside";
    if (dot(given, given) > radius * radius)
      return AssertionFailure() << "point " << i << " is outside the rounded sphere";
  }
  // The rounded centre may be off by half an ulp of each coordinate, the radius by two of its own.
  const ExactVec shift = centre - rounded;
  const Exact slack = radius * Exact(0x1p-50) + abs(shift.x) + abs(shift.y) + abs(shift.z) +
                      Exact(std::numeric_limits<double>::denorm_min()) * 3;
  if (radius > slack && (radius - slack) * (radius - slack) > squared)
    return AssertionFailure() << "the radius is wider than rounding asks";
  const Exact near = abs(Exact(sphere.exact_radius) * Exact(sphere.exact_radius) - squared);
  if (near > squared * Exact(0x1p-51) && sphere.exact_radius > std::numeric_limits<double>::min())
    return AssertionFailure() << "the exact radius is not the nearest";
  return AssertionSuccess();
}

}  // namespace cigsim::test
