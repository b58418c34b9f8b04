// SPDX-License-Identifier: MIT
// Hull and smallest sphere beside CGAL's, on all of Levine's distributions and degenerate points.
#include "tests/database/hull/cgal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "models/database/hull/hull.hpp"
#include "models/database/sphere/sphere.hpp"
#include "models/environment/point_sets.hpp"
#include "tests/database/hull/hull_check.hpp"

namespace cigsim {
namespace {

using Points = std::vector<Vec3>;
constexpr std::uint64_t kSeed = 1975;

TEST(BesideCgal, HullAndSphereOfLevinesDistributions) {
  for (const PointDistribution d : kPointDistributions)
    for (const std::uint32_t count : published_sizes(d))
      for (std::uint32_t number = 100; number < 103; ++number) {
        SCOPED_TRACE(std::string(name_of(d)) + ", " + std::to_string(count) + " points, seed " +
                     std::to_string(kSeed) + ", case " + std::to_string(number));
        const Points points = random_points(d, count, kSeed, number);
        EXPECT_EQ(test::corner_points(points, convex_hull(points)),
                  test::cgal_hull_corners(points));
        const double radius = minimum_sphere(points).exact_radius;
        EXPECT_NEAR(radius, test::cgal_radius(points), 1e-12 * radius);
      }
}

TEST(BesideCgal, HullOfManyPointsOnASphere) {
  Points points = random_points(PointDistribution::kSphere4, 20000, kSeed);
  for (Vec3& p : points) p = p * (1 / std::sqrt(dot(p, p)));
  EXPECT_EQ(test::corner_points(points, convex_hull(points)), test::cgal_hull_corners(points));
  EXPECT_NEAR(minimum_sphere(points).exact_radius, test::cgal_radius(points), 1e-12);
}

TEST(BesideCgal, HullAndSphereOfSmallGrids) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const unsigned side = 2 + random() % 8;
    Points points(30 + random() % 300);
    for (Vec3& p : points)
      p = {static_cast<double>(random() % side) * 0.1, static_cast<double>(random() % side) * 0.1,
           static_cast<double>(random() % side) * 0.1};
    EXPECT_EQ(test::corner_points(points, convex_hull(points)), test::cgal_hull_corners(points));
    const double radius = minimum_sphere(points).exact_radius;
    EXPECT_NEAR(radius, test::cgal_radius(points), 1e-12 * radius);
  }
}

}  // namespace
}  // namespace cigsim
