// SPDX-License-Identifier: MIT
// Both hulls on Levine's distributions, held against rationals, and Levine's counts.
#include "models/database/hull/hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/environment/point_sets.hpp"
#include "tests/database/hull/hull_check.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kSeed = 1975;

std::string trace(PointDistribution d, std::size_t count, std::uint32_t number) {
  return std::string(name_of(d)) + ", " + std::to_string(count) + " points, seed " +
         std::to_string(kSeed) + ", case " + std::to_string(number);
}

TEST(Hull, IsTheHullOnAllOfLevinesDistributions) {
  for (const PointDistribution d : kPointDistributions)
    for (const std::uint32_t count : {25u, 50u, 120u})
      for (std::uint32_t number = 0; number < 2; ++number) {
        SCOPED_TRACE(trace(d, count, number));
        const auto points = random_points(d, count, kSeed, number);
        const Hull fast = convex_hull(points), levine = levine_hull(points);
        EXPECT_TRUE(test::is_hull(points, fast));
        EXPECT_TRUE(test::is_hull(points, levine));
        EXPECT_TRUE(test::same_hull(points, fast, levine));
      }
}

TEST(Hull, BothAlgorithmsAgreeOnManyPoints) {
  for (const PointDistribution d : kPointDistributions)
    for (const std::uint32_t count : published_sizes(d)) {
      SCOPED_TRACE(trace(d, count, 7));
      const auto points = random_points(d, count, kSeed, 7);
      EXPECT_TRUE(test::same_hull(points, convex_hull(points), levine_hull(points)));
    }
}

TEST(Hull, IsTheHullOfPointsOnASphere) {
  auto points = random_points(PointDistribution::kSphere4, 150, kSeed);
  for (Vec3& p : points) p = p * (1 / std::sqrt(dot(p, p)));
  const Hull fast = convex_hull(points);
  EXPECT_TRUE(test::is_hull(points, fast));
  EXPECT_EQ(fast.vertices.size(), points.size());
  EXPECT_TRUE(test::same_hull(points, fast, levine_hull(points)));
}

// Levine 1975, ch. IV, end of section D: NPH = 2 NPTH − 4, for each point adds exactly two faces.
TEST(LevineHull, EveryAddedPointAddsTwoFaces) {
  for (const PointDistribution d : kPointDistributions)
    for (std::uint32_t number = 0; number < 20; ++number) {
      SCOPED_TRACE(trace(d, 200, number));
      const auto points = random_points(d, 200, kSeed, number);
      const Hull hull = levine_hull(points);
      // His points are all on the hull, so none that was added is covered again.
      EXPECT_EQ(hull.counters.added, hull.vertices.size());
      EXPECT_EQ(hull.counters.faces, 2 * hull.counters.added - 4);
      EXPECT_EQ(hull.triangles.size(), hull.counters.faces);
    }
}

// Levine 1975, ch. IV, section A: NEQ = 3 · NPTS · NPH, and app. I: tests a point of the hull are
// about ten times fewer.
TEST(LevineHull, TakesAboutATenthOfChandAndKapursTests) {
  EXPECT_EQ(equivalent_tests(3200, 100), 960000u);
  for (const PointDistribution d :
       {PointDistribution::kCube1, PointDistribution::kCube2, PointDistribution::kCube4}) {
    double ratio = 0;
    for (std::uint32_t number = 0; number < 20; ++number) {
      const auto points = random_points(d, 3200, kSeed, number);
      const Hull hull = levine_hull(points);
      ratio += static_cast<double>(equivalent_tests(points.size(), hull.triangles.size())) /
               static_cast<double>(hull.counters.tests) / 20;
    }
    EXPECT_GT(ratio, 5) << name_of(d);
    EXPECT_LT(ratio, 20) << name_of(d);
  }
}

// By hand: eight corners of a box and its centre. Steps 1 to 4 take all corners, step 5 one test of
// the centre against each of the 12 triangles.
TEST(LevineHull, CountsABoxByHand) {
  std::vector<Vec3> points;
  for (const double x : {0.0, 4.0})
    for (const double y : {0.0, 2.0})
      for (const double z : {0.0, 1.0}) points.push_back({x, y, z});
  points.push_back({2, 1, 0.5});
  const Hull hull = levine_hull(points);
  EXPECT_EQ(hull.vertices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(hull.triangles.size(), 12u);
  EXPECT_EQ(hull.counters.rounds, 1u);
  EXPECT_EQ(hull.counters.added, 8u);
  EXPECT_EQ(hull_facets(points, hull).size(), 6u);
}

TEST(Hull, GivesTheSameTwice) {
  const auto points = random_points(PointDistribution::kEllipse, 1000, kSeed);
  const Hull a = convex_hull(points), b = convex_hull(points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.counters, b.counters);
}

}  // namespace
}  // namespace cigsim
