// SPDX-License-Identifier: MIT
#include "sim/stability/exact_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "models/database/sphere/rounding.hpp"
#include "models/numeric/number.hpp"

namespace cigsim::stability {
namespace {

using Row = std::vector<Exact>;

// Solves a square system by Gauss and Jordan's elimination; none when it has no single solution.
// The last column is the right-hand side.
std::optional<Row> solve(std::vector<Row> m) {
  const std::size_t n = m.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && sgn(m[pivot][c]) == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(m[c], m[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c || sgn(m[r][c]) == 0) continue;
      const Exact factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k <= n; ++k) m[r][k] -= factor * m[c][k];
    }
  }
  Row out;
  for (std::size_t r = 0; r < n; ++r) out.push_back(Exact(m[r][n] / m[r][r]));
  return out;
}

struct ExactSphere {
  ExactVec centre;
  Exact square;  // of the radius
};

// Through the points, centre in their space; none where its weights are negative or not unique.
std::optional<ExactSphere> smallest_through(const std::vector<ExactVec>& points) {
  std::vector<ExactVec> edges;
  for (std::size_t i = 1; i < points.size(); ++i) edges.push_back(points[i] - points[0]);
  std::vector<Row> equations;
  for (const ExactVec& e : edges) {
    Row row;
    for (const ExactVec& other : edges) row.push_back(dot(e, other));
    row.push_back(Exact(dot(e, e) / 2));
    equations.push_back(row);
  }
  const auto weights = solve(equations);
  if (!weights) return std::nullopt;
  Exact sum(0);
  ExactVec toward{};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (sgn((*weights)[i]) < 0) return std::nullopt;
    sum += (*weights)[i];
    toward = toward + edges[i] * (*weights)[i];
  }
  if (sum > 1) return std::nullopt;
  return ExactSphere{points[0] + toward, dot(toward, toward)};
}

bool holds(const ExactVec& centre, const Exact& square, std::span<const Vec3> points) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    const ExactVec d = convert<Exact>(p) - centre;
    return dot(d, d) <= square;
  });
}

double ulp(double value) {
  return std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) - std::abs(value);
}

}  // namespace

SphereProof prove(const BoundingSphere& sphere, std::span<const Vec3> points) {
  std::vector<ExactVec> support;
  for (const std::uint32_t i : sphere.support) support.push_back(convert<Exact>(points[i]));
  SphereProof proof;
  if (support.empty()) return proof;
  const auto exact = smallest_through(support);
  const Exact radius(sphere.radius);
  proof.right = exact && holds(exact->centre, exact->square, points) &&
                holds(convert<Exact>(sphere.centre), radius * radius, points);
  if (!exact) return proof;
  const double below = root_nearest(exact->square);
  proof.excess = std::max(0.0, Exact(radius - Exact(below)).get_d());
  const Vec3& c = sphere.centre;
  proof.bound =
      std::hypot(ulp(c.x), ulp(c.y), ulp(c.z)) / 2 * (1 + 0x1p-50) + 2 * ulp(sphere.radius);
  return proof;
}

}  // namespace cigsim::stability
