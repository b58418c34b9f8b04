// SPDX-License-Identifier: MIT
// Side tests against a determinant of rationals written out here.
#include "models/numeric/plane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace cigsim {
namespace {

int rational_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const mpq_class ax(a.x), ay(a.y), az(a.z);
  const mpq_class m[3][3] = {{mpq_class(b.x) - ax, mpq_class(b.y) - ay, mpq_class(b.z) - az},
                             {mpq_class(c.x) - ax, mpq_class(c.y) - ay, mpq_class(c.z) - az},
                             {mpq_class(d.x) - ax, mpq_class(d.y) - ay, mpq_class(d.z) - az}};
  const mpq_class det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                        m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                        m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return sgn(det);
}

TEST(Plane, OrientationEqualsRationalDeterminantOnNearlyCoplanarPoints) {
  const std::uint64_t seed = 20260101;
  std::mt19937_64 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> ulps(-2, 2), decade(-8, 8);
  int zero = 0;
  for (int i = 0; i < 20000; ++i) {
    const double scale = std::pow(10.0, decade(random));
    Vec3 p[3];
    for (Vec3& v : p) v = {scale * unit(random), scale * unit(random), scale * unit(random)};
    if (i % 3 == 0) p[0].z = p[1].z = p[2].z = scale;
    const double s = unit(random), t = unit(random);
    Vec3 d = p[0] + (p[1] - p[0]) * s + (p[2] - p[0]) * t;
    for (double* c : {&d.x, &d.y, &d.z})
      for (int k = ulps(random); k != 0; k -= k > 0 ? 1 : -1)
        *c = std::nextafter(*c, k > 0 ? 1e300 : -1e300);
    const int expected = rational_orientation(p[0], p[1], p[2], d);
    zero += expected == 0;
    ASSERT_EQ(orientation(p[0], p[1], p[2], d), expected) << "case " << i;
    ASSERT_EQ(orientation(p[0], p[2], p[1], d), -expected) << "case " << i;
    ASSERT_EQ(side(plane_through(p[0], p[1], p[2]), d, convert<Exact>(d)), expected);
  }
  EXPECT_GT(zero, 100) << "the cases must include points exactly on the plane";
  EXPECT_GT(exact_fallbacks(), 1000u) << "the cases must reach the rational path";
}

TEST(Plane, TinyAndHugeCoordinatesKeepTheirSign) {
  for (const double s : {1e-200, 1e-160, 1e-100, 1e100, 1e150, 1e200}) {
    const Vec3 a{0, 0, 0}, b{s, 0, 0}, c{0, s, 0};
    EXPECT_EQ(orientation(a, b, c, {0, 0, s}), 1) << s;
    EXPECT_EQ(orientation(a, b, c, {0, 0, -s}), -1) << s;
    EXPECT_EQ(orientation(a, b, c, {s / 3, s / 7, 0}), 0) << s;
  }
}

TEST(Plane, WithNormalHasThatNormalExactly) {
  const Vec3 p{0.1, 0.2, 0.3};
  for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{-0.1, 0.7, 3}, Vec3{0, 0.3, -2}, Vec3{0, -1, 0},
                       Vec3{0, 0, -5}, Vec3{0, 0, 0.1}}) {
    const Plane plane = plane_with_normal(p, n);
    const ExactVec exact = exact_normal(plane);
    const ExactVec expected = convert<Exact>(n);
    const ExactVec parallel = cross(exact, expected);
    EXPECT_EQ(sgn(parallel.x), 0);
    EXPECT_EQ(sgn(parallel.y), 0);
    EXPECT_EQ(sgn(parallel.z), 0);
    EXPECT_EQ(sgn(dot(exact, expected)), 1);
    EXPECT_EQ(side(plane, p), 0);
    EXPECT_EQ(side(plane, p + n), 1);
    EXPECT_EQ(side(reversed(plane), p + n), -1);
  }
}

TEST(Plane, CollinearIsDecidedExactly) {
  EXPECT_TRUE(collinear({0, 0, 0}, {0.5, 0.25, 1}, {1, 0.5, 2}));
  EXPECT_TRUE(collinear({1, 2, 3}, {1, 2, 3}, {4, 5, 6}));
  const double next = std::nextafter(0.5, 1);
  EXPECT_FALSE(collinear({0, 0, 0}, {0.5, 0.25, 1}, {1, next, 2}));
}

}  // namespace
}  // namespace cigsim
