// SPDX-License-Identifier: MIT
#include "models/numeric/unit_normal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/environment/random.hpp"

namespace cigsim {
namespace {

// Element times length is the exact normal's element: compared by squares, signs apart.
void expect_direction(const Plane& plane, const Vec3& unit) {
  const ExactVec n = exact_normal(plane);
  const Exact square = dot(n, n);
  const auto off = [&](double element, const Exact& exact) {
    EXPECT_LE(sgn(exact) * element, 1);
    EXPECT_GE(sgn(exact) * element, -0x1p-38);
    return std::abs(std::abs(element) - std::sqrt(Exact(exact * exact / square).get_d()));
  };
  EXPECT_LT(off(unit.x, n.x), 0x1p-38);
  EXPECT_LT(off(unit.y, n.y), 0x1p-38);
  EXPECT_LT(off(unit.z, n.z), 0x1p-38);
}

Vec3 random_vector(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

TEST(UnitNormal, IsThatOfTheExactPlane) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const double scale = std::ldexp(1, static_cast<int>(random.below(400)) - 200);
    const Vec3 a = random_vector(random) * scale, b = random_vector(random) * scale,
               c = random_vector(random) * scale;
    const Plane plane = plane_through(a, b, c);
    expect_direction(plane, unit_normal(plane));
  }
}

// Three points almost on a line: the rounded normal points anywhere.
TEST(UnitNormal, OfASliverIsNotTheRoundedOne) {
  int turned = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Vec3 a = random_vector(random), b = random_vector(random);
    const double t = random.unit();
    const Vec3 c = a + (b - a) * t + random_vector(random) * 1e-14;
    const Plane plane = plane_through(a, b, c);
    const Vec3 unit = unit_normal(plane);
    if (unit == Vec3{}) continue;
    expect_direction(plane, unit);
    const double length = std::sqrt(dot(plane.normal, plane.normal));
    turned += dot(plane.normal, unit) < 0.999999 * length;
  }
  EXPECT_GT(turned, 10);  // what the exact normal is for
}

TEST(UnitNormal, HoldsWhereProductsOverflowOrVanish) {
  const Plane huge = plane_through({0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0});
  EXPECT_EQ(unit_normal(huge), (Vec3{0, 0, 1}));
  const Plane tiny = plane_through({0, 0, 0}, {0, 1e-200, 0}, {0, 0, 1e-200});
  EXPECT_EQ(unit_normal(tiny), (Vec3{1, 0, 0}));
}

TEST(UnitNormal, IsZeroWhereThereIsNone) {
  EXPECT_EQ(unit_normal(plane_through({1, 2, 3}, {2, 4, 6}, {3, 6, 9})), Vec3{});
  EXPECT_EQ(unit_normal(plane_through({1, 2, 3}, {1, 2, 3}, {1, 2, 3})), Vec3{});
}

}  // namespace
}  // namespace cigsim
