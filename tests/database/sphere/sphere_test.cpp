// SPDX-License-Identifier: MIT
// The fast smallest sphere on Levine's distributions and on points about a sphere.
#include "models/database/sphere/sphere.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "models/database/sphere/rounding.hpp"
#include "models/environment/point_sets.hpp"
#include "tests/database/sphere/sphere_check.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kSeed = 1975;

TEST(MinimumSphere, IsSmallestOnAllOfLevinesDistributions) {
  for (const PointDistribution d : kPointDistributions)
    for (const std::uint32_t count : {4u, 25u, 200u, 2200u})
      for (std::uint32_t number = 0; number < 2; ++number) {
        SCOPED_TRACE(std::string(name_of(d)) + ", " + std::to_string(count) + " points, case " +
                     std::to_string(number));
        const auto points = random_points(d, count, kSeed, number);
        EXPECT_TRUE(test::is_smallest_sphere(points, minimum_sphere(points)));
      }
}

TEST(MinimumSphere, IsSmallestOfFewRandomPoints) {
  for (std::uint32_t seed = 1; seed <= 800; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<Vec3> points(1 + random() % 8);
    for (Vec3& p : points) p = {u(random), u(random), u(random)};
    ASSERT_TRUE(test::is_smallest_sphere(points, minimum_sphere(points)));
  }
}

// Thousands of points that doubles cannot tell from one sphere, more than a sample holds.
TEST(MinimumSphere, IsSmallestOfPointsRoundedToASphere) {
  auto points = random_points(PointDistribution::kSphere4, 6000, kSeed);
  for (Vec3& p : points) p = p * (1 / std::sqrt(dot(p, p))) + Vec3{3, -2, 1};
  EXPECT_TRUE(test::is_smallest_sphere(points, minimum_sphere(points)));
}

TEST(MinimumSphere, DoesNotDependOnTheOrderOfThePoints) {
  auto points = random_points(PointDistribution::kSphere1, 5000, kSeed);
  const BoundingSphere first = minimum_sphere(points);
  std::mt19937 random(8);
  for (int i = 0; i < 5; ++i) {
    std::shuffle(points.begin(), points.end(), random);
    const BoundingSphere again = minimum_sphere(points);
    EXPECT_EQ(again.centre, first.centre);
    EXPECT_EQ(again.radius, first.radius);
  }
}

TEST(Rounding, RootsAreRoundedAsTold) {
  EXPECT_EQ(root_up(Exact(4)), 2);
  EXPECT_EQ(root_up(Exact(0)), 0);
  for (const double value : {2.0, 3.0, 0.5, 1e-300, 1e300, 5e-324, 1.7e308}) {
    const Exact exact(value);
    const double up = root_up(exact), below = std::nextafter(up, 0);
    EXPECT_GE(Exact(up) * Exact(up), exact) << value;
    EXPECT_LT(Exact(below) * Exact(below), exact) << value;
    EXPECT_EQ(root_nearest(exact), std::sqrt(value)) << value;
  }
  Exact huge(1.7e308);
  huge *= huge;
  EXPECT_EQ(root_up(huge), 1.7e308);
  EXPECT_TRUE(std::isinf(root_up(huge * 4)));
  EXPECT_EQ(nearest_double(Exact(1, 3)), 1.0 / 3);
  EXPECT_EQ(nearest_double(Exact(-2, 3)), -2.0 / 3);
  EXPECT_EQ(sum_up(1, 0x1p-60), 1 + 0x1p-52);
}

}  // namespace
}  // namespace cigsim
