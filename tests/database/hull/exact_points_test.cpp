// SPDX-License-Identifier: MIT
// Exact predicates on points against rationals.
#include "models/database/hull/exact_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "models/numeric/expansion.hpp"
#include "tests/database/hull/hull_check.hpp"

namespace cigsim {
namespace {

template <std::size_t N>
Exact value_of(const Expansion<N>& e) {
  Exact sum = 0;
  for (std::size_t i = 0; i < e.size; ++i) sum += Exact(e.part[i]);
  return sum;
}

TEST(Expansion, SumsAndProductsAreThoseOfRationals) {
  const std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> power(-80, 80);
  const auto number = [&] {
    return random() % 8 == 0 ? 0.0 : std::ldexp(unit(random), power(random));
  };
  for (int i = 0; i < 5000; ++i) {
    double v[8];
    for (double& x : v) x = number();
    const auto a = difference(v[0], v[1]), b = difference(v[2], v[3]), c = difference(v[4], v[5]);
    const Exact ea = Exact(v[0]) - Exact(v[1]), eb = Exact(v[2]) - Exact(v[3]),
                ec = Exact(v[4]) - Exact(v[5]);
    ASSERT_EQ(value_of(a), ea);
    ASSERT_EQ(value_of(a * b), ea * eb);
    ASSERT_EQ(value_of(a * b - b * c), Exact(ea * eb - eb * ec));
    ASSERT_EQ(value_of((a * b - b * c) * c), Exact((ea * eb - eb * ec) * ec));
    ASSERT_EQ((a * b - b * c).sign(), sgn(Exact(ea * eb - eb * ec)));
    ASSERT_EQ(((a * b) - (a * b)).sign(), 0);
  }
}

TEST(ExactPoints, SidesAreThoseOfRationalsAtEveryScale) {
  const std::uint64_t seed = 12;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> ulps(-2, 2);
  int zeros = 0;
  std::uint64_t exact = 0;
  for (int i = 0; i < 6000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 5) * 450 - 900);
    std::vector<Vec3> p;
    for (int k = 0; k < 3; ++k) p.push_back({unit(random), unit(random), unit(random)});
    if (i % 3 == 0) p[0].z = p[1].z = p[2].z = 0.25;
    if (i % 7 == 0) p[0].z = p[1].z = p[2].z = 0x1p-400;
    Vec3 d = p[0] + (p[1] - p[0]) * unit(random) + (p[2] - p[0]) * unit(random);
    for (double* c : {&d.x, &d.y, &d.z})
      for (int k = ulps(random); k != 0; k -= k > 0 ? 1 : -1)
        *c = std::nextafter(*c, k > 0 ? 1e300 : -1e300);
    p.push_back(d);
    for (Vec3& v : p) v = v * scale;
    const ExactPoints points(p);
    const int expected = test::rational_side(p[0], p[1], p[2], p[3]);
    zeros += expected == 0;
    ASSERT_EQ(points.exact_side(0, 1, 2, 3), expected) << "case " << i;
    ASSERT_EQ(points.side(0, 1, 2, 3, exact), expected) << "case " << i;
    ASSERT_EQ(points.side(1, 0, 2, 3, exact), -expected) << "case " << i;
    const FilterPlane plane = points.plane(0, 1, 2);
    const double value = plane.value(points.scaled(3));
    if (std::abs(value) > plane.bound) {
      ASSERT_EQ(value > 0 ? 1 : -1, expected) << "case " << i;
    }
  }
  EXPECT_GT(zeros, 100) << "the cases must include points exactly on the plane";
  EXPECT_GT(exact, 1000u) << "the cases must be near the plane";
}

TEST(ExactPoints, CollinearPointsAreFoundExactly) {
  const std::vector<Vec3> p{
      {0, 0, 0}, {1, 2, 3}, {3, 6, 9}, {3, 6, std::nextafter(9, 10)}, {1, 2, 3}};
  const ExactPoints points(p);
  EXPECT_TRUE(points.collinear(0, 1, 2));
  EXPECT_FALSE(points.collinear(0, 1, 3));
  EXPECT_TRUE(points.collinear(0, 1, 4));
  EXPECT_EQ(points.turn(0, 0, 1, 3), 1);  // y, z: (2, 3) to (6, 9 and a little)
  EXPECT_EQ(points.turn(2, 0, 1, 2), 0);
}

}  // namespace
}  // namespace cigsim
