// SPDX-License-Identifier: MIT
// The clearance of a side test against the exact distance of the plane.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "models/environment/random.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim {
namespace {

Vec3 random_point(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

// Square of the distance, times the square of the exact normal.
Exact value_squared(const Plane& plane, const Vec3& point) {
  const Exact value =
      dot(exact_normal(plane), convert<Exact>(point) - convert<Exact>(plane.exact.p));
  return value * value;
}

TEST(Clearance, IsNeverMoreThanTheExactDistanceAndSeldomMuchLess) {
  constexpr std::uint64_t kSeed = 61;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  std::uint64_t close = 0, none = 0;
  constexpr int kCases = 20000;
  for (int i = 0; i < kCases; ++i) {
    const double size = std::pow(10, random.between(-12, 12));
    const double flat = i % 4 == 0 ? std::pow(10, random.between(-15, 0)) : 1;
    const Vec3 a = random_point(random, size), b = random_point(random, size);
    const Vec3 c = i % 4 == 0
                       ? a + (b - a) * random.between(-2, 2) + random_point(random, size * flat)
                       : random_point(random, size);
    const Plane plane = plane_through(a, b, c);
    // Anywhere, or next to a corner.
    const Vec3 point = i % 2 == 0
                           ? random_point(random, size * std::pow(10, random.between(-1, 6)))
                           : a + random_point(random, size * std::pow(10, random.between(-17, 0)));
    double clearance = -1;
    ASSERT_EQ(side(plane, point, clearance), side(plane, point));
    ASSERT_GE(clearance, 0);
    const ExactVec n = exact_normal(plane);
    const Exact squared = Exact(clearance) * Exact(clearance) * dot(n, n);
    const Exact true_squared = value_squared(plane, point);
    ASSERT_LE(squared, true_squared) << "case " << i;
    close += squared * 4 >= true_squared && clearance > 0;
    none += clearance == 0;
  }
  EXPECT_GT(close, kCases * 8 / 10);
  EXPECT_GT(none, 0u) << "points too near for the filter";
}

TEST(Clearance, IsNoneOnThePlaneAndWhereTheFilterCannotTell) {
  double clearance = 1;
  EXPECT_EQ(side(axis_plane(0, 4), {4, 7, 9}, clearance), 0);
  EXPECT_EQ(clearance, 0);
  EXPECT_EQ(side(axis_plane(0, 4), {7, 7, 9}, clearance), 1);
  EXPECT_LE(clearance, 3);
  EXPECT_GT(clearance, 2.999);
  // No normal at all, numbers that vanish, and numbers that overflow.
  EXPECT_EQ(side(plane_through({1, 1, 1}, {2, 2, 2}, {3, 3, 3}), {4, 7, 9}, clearance), 0);
  EXPECT_EQ(clearance, 0);
  for (const double size : {1e-160, 1e-310, 1e160}) {
    const Plane plane = plane_through({0, 0, 0}, {size, 0, 0}, {0, size, 0});
    EXPECT_EQ(side(plane, {0, 0, size}, clearance), 1) << size;
    EXPECT_GE(clearance, 0) << size;
    EXPECT_LE(clearance, size) << size;
  }
}

}  // namespace
}  // namespace cigsim
