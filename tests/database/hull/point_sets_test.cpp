// SPDX-License-Identifier: MIT
// Levine's data sets (1975, ch. VII): where the points lie and how they are spread.
#include "models/environment/point_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

TEST(PointSets, LieInTheirRegionsAndAreTheSameEachTime) {
  for (const PointDistribution d : kPointDistributions) {
    SCOPED_TRACE(name_of(d));
    const auto points = random_points(d, 500, 3, 17);
    ASSERT_EQ(points.size(), 500u);
    for (const Vec3& p : points) EXPECT_TRUE(inside(d, p));
    EXPECT_EQ(points, random_points(d, 500, 3, 17));
    EXPECT_NE(points, random_points(d, 500, 3, 18));
    EXPECT_NE(points, random_points(d, 500, 4, 17));
  }
}

TEST(PointSets, SizesOfTheTableInChapterSeven) {
  EXPECT_EQ(published_sizes(PointDistribution::kCube4).back(), 3200u);
  EXPECT_EQ(published_sizes(PointDistribution::kPolyhedron).back(), 1600u);
  EXPECT_EQ(published_sizes(PointDistribution::kEllipse).back(), 1600u);
  EXPECT_EQ(published_sizes(PointDistribution::kSphere1).back(), 800u);
  for (const PointDistribution d : kPointDistributions)
    EXPECT_EQ(published_sizes(d).front(), 25u) << name_of(d);
}

TEST(PointSets, NormalNumbersHaveTheSpreadOfACutNormalDistribution) {
  // Variance of a normal number kept within ±n: 1 − 2 n φ(n) / (2Φ(n) − 1).
  for (const auto& [d, n] :
       {std::pair(PointDistribution::kCube1, 1.0), std::pair(PointDistribution::kCube2, 2.0),
        std::pair(PointDistribution::kCube4, 4.0)}) {
    double sum = 0, squares = 0;
    constexpr int kPoints = 40000;
    for (const Vec3& p : random_points(d, kPoints, 5)) {
      sum += p.x + p.y + p.z;
      squares += dot(p, p);
    }
    const double density = std::exp(-n * n / 2) / std::sqrt(2 * std::acos(-1.0));
    const double variance = 1 - 2 * n * density / std::erf(n / std::sqrt(2.0));
    EXPECT_NEAR(sum / (3 * kPoints), 0, 0.015) << n;
    EXPECT_NEAR(squares / (3 * kPoints), variance, 0.02) << n;
  }
}

TEST(PointSets, UniformOnesFillTheirRegionEvenly) {
  for (const auto& [d, centre, mean] :
       {std::tuple(PointDistribution::kPolyhedron, Vec3{1, 0.5, 0.5},
                   1.0 / 3 + 1.0 / 12 + 1.0 / 12),
        std::tuple(PointDistribution::kEllipse, Vec3{0, 0, 0}, 4.0 / 5 + 1.0 / 5 + 1.0 / 5)}) {
    double squares = 0;
    constexpr int kPoints = 40000;
    for (const Vec3& p : random_points(d, kPoints, 5))
      squares += dot(p - centre, p - centre) / kPoints;
    EXPECT_NEAR(squares, mean, 0.02) << name_of(d);
  }
}

}  // namespace
}  // namespace cigsim
