// SPDX-License-Identifier: MIT
// The front against brute force over all pairs.
#include "sim/measure/pareto.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "models/environment/random.hpp"

namespace cigsim {
namespace {

std::vector<bool> by_brute_force(const std::vector<Vec2>& points) {
  std::vector<bool> front;
  for (const Vec2& p : points) {
    bool beaten = false;
    for (const Vec2& q : points) beaten |= q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y);
    front.push_back(!beaten);
  }
  return front;
}

TEST(ParetoFront, IsThatOfBruteForce) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Vec2> points(random.below(30));
    // On a coarse grid, so that points and coordinates coincide.
    const double grid = 1 + random.below(12);
    for (Vec2& p : points)
      p = {static_cast<double>(random.below(static_cast<std::uint64_t>(grid))),
           static_cast<double>(random.below(static_cast<std::uint64_t>(grid)))};
    if (!points.empty() && random.below(4) == 0)
      points[0].y = std::numeric_limits<double>::infinity();
    EXPECT_EQ(pareto_front(points), by_brute_force(points));
  }
}

}  // namespace
}  // namespace cigsim
