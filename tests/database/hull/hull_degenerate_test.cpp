// SPDX-License-Identifier: MIT
// Hulls of points that are repeated, on one line, in one plane, on a grid, and very large or small.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "models/database/hull/hull.hpp"
#include "tests/database/hull/hull_check.hpp"

namespace cigsim {
namespace {

using Points = std::vector<Vec3>;

void for_both(const std::function<void(Hull (*)(std::span<const Vec3>))>& check) {
  {
    SCOPED_TRACE("convex_hull");
    check(convex_hull);
  }
  SCOPED_TRACE("levine_hull");
  check(levine_hull);
}

TEST(HullDegenerate, OfNothingIsNothing) {
  for_both([](auto hull_of) {
    const Hull hull = hull_of({});
    EXPECT_EQ(hull.dimension, -1);
    EXPECT_TRUE(hull.vertices.empty());
    EXPECT_TRUE(hull_facets({}, hull).empty());
  });
}

TEST(HullDegenerate, OfEqualPointsIsOnePoint) {
  for_both([](auto hull_of) {
    for (const std::size_t n : {1u, 2u, 3u, 4u, 100u}) {
      const Points points(n, Vec3{3, -0.1, 1e10});
      const Hull hull = hull_of(points);
      EXPECT_EQ(hull.dimension, 0) << n;
      EXPECT_EQ(hull.vertices.size(), 1u) << n;
      EXPECT_TRUE(hull.triangles.empty()) << n;
    }
  });
}

TEST(HullDegenerate, OfALineIsItsEnds) {
  for_both([](auto hull_of) {
    Points points;
    for (int i = 0; i < 50; ++i) {
      const double t = (i * 37) % 50 - 20;
      points.push_back({t, 3 * t, -7 * t});
      points.push_back(points.back());
    }
    const Hull hull = hull_of(points);
    EXPECT_EQ(hull.dimension, 1);
    ASSERT_EQ(hull.vertices.size(), 2u);
    EXPECT_EQ(test::corner_points(points, hull), (Points{{-20, -60, 140}, {29, 87, -203}}));
  });
}

// A third of a line's points may be off it by rounding; exactly, these span space.
TEST(HullDegenerate, PointsNearlyOnALineAreNoLine) {
  for_both([](auto hull_of) {
    Points points;
    for (int i = 0; i < 40; ++i) points.push_back({i * 0.1, i * 0.3, i * 0.7});
    const Hull hull = hull_of(points);
    EXPECT_EQ(hull.dimension, 3);
    EXPECT_TRUE(test::is_hull(points, hull));
  });
}

TEST(HullDegenerate, OfAPlaneIsAPolygon) {
  for_both([](auto hull_of) {
    // x + 2y + 3z = 6 on a grid, a hexagon with points on its sides and inside.
    Points points;
    for (int y = -6; y <= 6; ++y)
      for (int z = -6; z <= 6; ++z)
        if (std::abs(y + z) <= 6) points.push_back({6.0 - 2 * y - 3 * z, 1.0 * y, 1.0 * z});
    points.push_back(points.front());
    const Hull hull = hull_of(points);
    EXPECT_EQ(hull.dimension, 2);
    EXPECT_EQ(hull.vertices.size(), 6u);
    EXPECT_TRUE(hull.triangles.empty());
    ASSERT_EQ(hull_facets(points, hull).size(), 1u);
    EXPECT_EQ(hull_facets(points, hull)[0], hull.vertices);
    // In order round the polygon: each corner turns the same way.
    for (std::size_t i = 0; i < 6; ++i) {
      const auto corner = [&](std::size_t k) { return points[hull.vertices[k % 6]]; };
      const Vec3 turn = cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i + 1));
      EXPECT_GT(dot(turn, {1, 2, 3}), 0) << i;
    }
  });
}

TEST(HullDegenerate, OfEachAxisPlaneIsARectangle) {
  for_both([](auto hull_of) {
    for (int axis = 0; axis < 3; ++axis) {
      Points points;
      for (int a = 0; a <= 4; ++a)
        for (int b = 0; b <= 3; ++b) {
          const double u = a * 0.1, v = b * 0.7;
          points.push_back(axis == 0 ? Vec3{9, u, v} : axis == 1 ? Vec3{u, 9, v} : Vec3{u, v, 9});
        }
      const Hull hull = hull_of(points);
      EXPECT_EQ(hull.dimension, 2);
      EXPECT_EQ(hull.vertices.size(), 4u);
    }
  });
}

TEST(HullDegenerate, OfAGridIsACubeOfEightVertices) {
  for_both([](auto hull_of) {
    Points points;
    for (int x = 0; x <= 7; ++x)
      for (int y = 0; y <= 7; ++y)
        for (int z = 0; z <= 7; ++z) points.push_back({x * 0.125, y * 0.125, z * 0.125});
    std::shuffle(points.begin(), points.end(), std::mt19937(5));
    const Hull hull = hull_of(points);
    EXPECT_TRUE(test::is_hull(points, hull));
    EXPECT_EQ(hull.vertices.size(), 8u);
    const auto facets = hull_facets(points, hull);
    ASSERT_EQ(facets.size(), 6u);
    for (const auto& facet : facets) EXPECT_EQ(facet.size(), 4u);
  });
}

// Small whole coordinates: most points are repeated, collinear or coplanar with others.
TEST(HullDegenerate, OfRandomSmallGridsAndSlabs) {
  for_both([](auto hull_of) {
    for (std::uint32_t seed = 1; seed <= 120; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const int size[3] = {1 + static_cast<int>(random() % 4), 1 + static_cast<int>(random() % 4),
                           1 + static_cast<int>(random() % 4)};
      const std::size_t count = 4 + random() % 60;
      Points points;
      for (std::size_t i = 0; i < count; ++i)
        points.push_back({static_cast<double>(random() % (size[0] + 1)) * 0.1,
                          static_cast<double>(random() % (size[1] + 1)) * 0.3,
                          static_cast<double>(random() % (size[2] + 1)) * 0.7});
      const Hull hull = hull_of(points);
      if (hull.dimension == 3) {
        ASSERT_TRUE(test::is_hull(points, hull));
      } else {
        for (std::size_t i = 3; i < points.size(); ++i)
          ASSERT_EQ(test::rational_side(points[0], points[1], points[2], points[i]), 0);
      }
      ASSERT_TRUE(test::same_hull(points, hull, convex_hull(points)));
    }
  });
}

TEST(HullDegenerate, PrismOverACircleKeepsItsCoplanarRims) {
  for_both([](auto hull_of) {
    Points points;
    for (int i = 0; i < 64; ++i)
      for (const double z : {-1.0, 0.0, 1.0})
        points.push_back({std::cos(i * 0.0981747704), std::sin(i * 0.0981747704), z});
    const Hull hull = hull_of(points);
    EXPECT_TRUE(test::is_hull(points, hull));
    EXPECT_EQ(hull.vertices.size(), 128u);
    EXPECT_EQ(hull_facets(points, hull).size(), 66u);
  });
}

TEST(HullDegenerate, AnyScaleOfDoublesWillDo) {
  for_both([](auto hull_of) {
    Points unit;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int i = 0; i < 80; ++i) unit.push_back({u(random), u(random), u(random)});
    const Hull expected = hull_of(unit);
    ASSERT_TRUE(test::is_hull(unit, expected));
    for (const double s : {0x1p-960, 0x1p-500, 0x1p-300, 0x1p300, 0x1p900, 0x1p1023}) {
      SCOPED_TRACE(s);
      Points points = unit;
      for (Vec3& p : points) p = p * s;
      const Hull hull = hull_of(points);
      EXPECT_EQ(hull.vertices, expected.vertices);
      EXPECT_EQ(hull.triangles, expected.triangles);
    }
  });
}

TEST(HullDegenerate, CoordinatesOfVeryDifferentSizesTogether) {
  for_both([](auto hull_of) {
    const Points points{{0, 0, 0},           {1e300, 0, 0},  {0, 1e-300, 0},
                        {0, 0, 1e-320},      {1e299, 0, 0},  {1e300, 1e-310, 0},
                        {0, 1e-300, 1e-323}, {5e-324, 0, 0}, {1, 1e-301, 1e-322}};
    const Hull hull = hull_of(points);
    EXPECT_TRUE(test::is_hull(points, hull));
    // 1e-320 above the plane of the others: a flat tetrahedron none the less.
    const Points flat{{0, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}, {1e300, 1e300, 1e-320}};
    EXPECT_TRUE(test::is_hull(flat, hull_of(flat)));
  });
}

TEST(HullDegenerate, ACornerOneUlpOutIsAVertex) {
  for_both([](auto hull_of) {
    Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, -1}};
    points.push_back({0.5, 0.5, 0});
    EXPECT_EQ(hull_of(points).vertices.size(), 5u);
    points.back().z = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(hull_of(points).vertices.size(), 6u);
    EXPECT_TRUE(test::is_hull(points, hull_of(points)));
  });
}

TEST(HullDegenerate, FarFromTheOriginNothingIsLost) {
  for_both([](auto hull_of) {
    Points points;
    std::mt19937 random(9);
    for (int i = 0; i < 200; ++i)
      points.push_back({1e15 + static_cast<double>(random() % 64) * 0.125,
                        -1e15 + static_cast<double>(random() % 64) * 0.125,
                        1e15 + static_cast<double>(random() % 64) * 0.125});
    EXPECT_TRUE(test::is_hull(points, hull_of(points)));
  });
}

TEST(HullDegenerate, CoordinatesThatAreNoNumbersAreRefused) {
  for_both([](auto hull_of) {
    for (const double bad :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
      for (int axis = 0; axis < 3; ++axis) {
        Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        (axis == 0 ? points[2].x : axis == 1 ? points[2].y : points[2].z) = bad;
        EXPECT_THROW(hull_of(points), std::invalid_argument);
      }
  });
}

}  // namespace
}  // namespace cigsim
