// SPDX-License-Identifier: MIT
// Smallest spheres of points that are repeated, on a line, on a circle, on a sphere, and very large
// or small, by both methods.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "models/database/sphere/sphere.hpp"
#include "tests/database/sphere/sphere_check.hpp"

namespace cigsim {
namespace {

using Points = std::vector<Vec3>;

// Both methods; Levine's without its limit.
void expect_smallest(const Points& points, std::size_t support, double radius) {
  const BoundingSphere fast = minimum_sphere(points);
  EXPECT_TRUE(test::is_smallest_sphere(points, fast));
  LevineSphereOptions options;
  options.last_point.reset();
  const LevineSphere levine = levine_sphere(points, levine_hull(points), options);
  ASSERT_TRUE(levine.sphere.has_value());
  EXPECT_TRUE(test::is_smallest_sphere(points, *levine.sphere));
  EXPECT_EQ(levine.selected.size(), levine.sphere->support.size());
  EXPECT_EQ(fast.exact_radius, levine.sphere->exact_radius);
  EXPECT_EQ(fast.centre, levine.sphere->centre);
  EXPECT_EQ(fast.radius, levine.sphere->radius);
  if (support > 0) {
    EXPECT_EQ(levine.selected.size(), support);
  }
  if (radius >= 0) {
    EXPECT_DOUBLE_EQ(fast.exact_radius, radius);
  }
}

TEST(SphereDegenerate, OfOnePointHasNoRadius) {
  expect_smallest({{1, 2, 3}}, 1, 0);
  expect_smallest(Points(50, Vec3{0.1, 0.2, 0.3}), 1, 0);
  expect_smallest({{0, 0, 0}}, 1, 0);
}

TEST(SphereDegenerate, OfALineStandsOnItsEnds) {
  Points points;
  for (int i = 0; i < 40; ++i) points.push_back({(i * 7) % 40 * 1.0, (i * 7) % 40 * 2.0, 5});
  points.insert(points.end(), points.begin(), points.begin() + 10);
  expect_smallest(points, 2, 39 * std::sqrt(5.0) / 2);
}

TEST(SphereDegenerate, OfTriangles) {
  expect_smallest({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, 2, 2.5);                 // a right angle
  expect_smallest({{0, 0, 0}, {10, 0, 0}, {5, 1, 0}}, 2, 5);                  // obtuse
  expect_smallest({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 3, std::sqrt(2.0 / 3));  // acute
}

TEST(SphereDegenerate, OfTetrahedra) {
  expect_smallest({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, 4, std::sqrt(3.0));
  // A flat one, whose centre is outside: three points make the sphere.
  expect_smallest({{1, 0, 0}, {-0.5, 0.875, 0}, {-0.5, -0.875, 0}, {0, 0, 0.125}}, 3, -1);
}

TEST(SphereDegenerate, OfPolygonsIsTheirCircle) {
  Points points;
  for (int i = 0; i < 30; ++i) points.push_back({std::cos(i * 0.2094), 2, std::sin(i * 0.2094)});
  expect_smallest(points, 0, -1);
  Points grid;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 3; ++y) grid.push_back({x * 1.0, y * 1.0, x + y + 0.5});
  expect_smallest(grid, 0, -1);
}

TEST(SphereDegenerate, OfCospherePointsRestsOnSomeOfThem) {
  Points cube;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) cube.push_back({x, y, z});
  expect_smallest(cube, 2, std::sqrt(3.0));
  expect_smallest({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, 2, 1);
  // Whole points at distance 15 from (7, 7, 7), no two opposite.
  Points shell;
  for (int x = -15; x <= 15; ++x)
    for (int y = -15; y <= 15; ++y)
      for (int z = -15; z <= 15; ++z)
        if (x * x + y * y + z * z == 225 && x + y + 2 * z > -8)
          shell.push_back({x + 7.0, y + 7.0, z + 7.0});
  expect_smallest(shell, 0, -1);
  Points all = shell;
  for (const Vec3& p : shell) all.push_back({14 - p.x, 14 - p.y, 14 - p.z});
  expect_smallest(all, 2, 15);
}

TEST(SphereDegenerate, OfRandomSmallGrids) {
  for (std::uint32_t seed = 1; seed <= 250; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const unsigned side = 2 + random() % 4;
    Points points(1 + random() % 30);
    for (Vec3& p : points)
      p = {static_cast<double>(random() % side) * 0.1, static_cast<double>(random() % side) * 0.1,
           static_cast<double>(random() % side) * 0.1};
    expect_smallest(points, 0, -1);
  }
}

TEST(SphereDegenerate, AnyScaleOfDoublesWillDo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  Points unit(60);
  for (Vec3& p : unit) p = {u(random), u(random), u(random)};
  const BoundingSphere expected = minimum_sphere(unit);
  for (const double s : {0x1p-960, 0x1p-500, 0x1p-99, 0x1p99, 0x1p300, 0x1p1022}) {
    SCOPED_TRACE(s);
    Points points = unit;
    for (Vec3& p : points) p = p * s;
    expect_smallest(points, expected.support.size(), expected.exact_radius * s);
    EXPECT_EQ(minimum_sphere(points).support, expected.support);
  }
}

TEST(SphereDegenerate, CoordinatesOfVeryDifferentSizesTogether) {
  expect_smallest({{0, 0, 0}, {1e300, 0, 0}, {0, 1e-300, 0}, {0, 0, 5e-324}}, 0, -1);
  expect_smallest({{1, 1, 1}, {1, 1, 1 + 0x1p-52}, {1, 1 + 0x1p-52, 1}}, 2, -1);
  expect_smallest({{1, 1e-200, 0}, {1, -1e-200, 0}, {1, 0, 1e-200}, {1, 0, -1.5e-200}}, 0, -1);
  expect_smallest({{1, 0, 0}, {1, 1.5e-160, 0}, {1, 0, 1.49e-160}, {1, 1e-170, 1.4999999e-160}}, 0,
                  -1);
  expect_smallest({{1e17, 1e17, 1e17}, {1e17 + 16, 1e17, 1e17}, {1e17, 1e17 + 32, 1e17}}, 0, -1);
}

// Equal but for denormals: the sphere is a few of them wide.
TEST(SphereDegenerate, OfTheSmallestDoubles) {
  const double d = std::numeric_limits<double>::denorm_min();
  const Points points{{0, 0, 0}, {d, 0, 0}, {0, 3 * d, 0}, {0, 0, 2 * d}};
  EXPECT_TRUE(test::is_smallest_sphere(points, minimum_sphere(points)));
}

TEST(SphereDegenerate, ARadiusBeyondTheLargestDoubleIsRefused) {
  const double m = std::numeric_limits<double>::max();
  const Points points{{m, m, m}, {-m, -m, -m}};
  EXPECT_THROW(minimum_sphere(points), std::invalid_argument);
  EXPECT_THROW(levine_sphere(points, convex_hull(points)), std::invalid_argument);
  EXPECT_TRUE(test::is_smallest_sphere(Points{{m, m, m}, {m, -m, m}},
                                       minimum_sphere(Points{{m, m, m}, {m, -m, m}})));
}

TEST(SphereDegenerate, NothingAndNoNumbersAreRefused) {
  EXPECT_THROW(minimum_sphere({}), std::invalid_argument);
  EXPECT_THROW(levine_sphere({}, Hull()), std::invalid_argument);
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Points points(20, Vec3{1, 2, 3});
    points[13].y = bad;
    EXPECT_THROW(minimum_sphere(points), std::invalid_argument);
  }
}

}  // namespace
}  // namespace cigsim
