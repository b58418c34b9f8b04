// SPDX-License-Identifier: MIT
#include "sim/experiments/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cigsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Percentile, IsTheLargestOfTheSmallestShare) {
  const std::vector<double> values{5, 1, 4, 2, 3, 10, 9, 8, 7, 6};
  EXPECT_EQ(percentile(values, 0.5), 5);
  EXPECT_EQ(percentile(values, 0.6), 6);
  EXPECT_EQ(percentile(values, 0.7), 7);
  EXPECT_EQ(percentile(values, 0.8), 8);
  EXPECT_EQ(percentile(values, 1), 10);
  EXPECT_EQ(percentile({3}, 0.01), 3);
  EXPECT_EQ(percentile({}, 0.5), 0);
  EXPECT_EQ(percentile({1, kInfinity, kInfinity}, 0.5), kInfinity);
}

TEST(PowerFit, FindsAPowerAndUsesTheLastFourPointsOnly) {
  std::vector<Vec2> points{{1, 1000}, {2, 1}};
  for (const double x : {10.0, 20.0, 40.0, 80.0}) points.push_back({x, 3 * std::pow(x, 0.29)});
  const PowerFit fit = power_fit(points);
  EXPECT_EQ(fit.points, 4u);
  EXPECT_NEAR(fit.exponent, 0.29, 1e-12);
  EXPECT_NEAR(fit.intercept, std::log10(3), 1e-12);
}

TEST(PowerFit, LeavesOutWhatHasNoLogarithm) {
  const PowerFit fit = power_fit(std::vector<Vec2>{{1, 1}, {10, 10}, {20, kInfinity}, {30, 0}});
  EXPECT_EQ(fit.points, 2u);
  EXPECT_NEAR(fit.exponent, 1, 1e-12);
  EXPECT_EQ(power_fit(std::vector<Vec2>{{5, 5}}).exponent, 0);
  EXPECT_EQ(power_fit(std::vector<Vec2>{{5, 5}, {5, 6}}).exponent, 0);
}

TEST(LineFit, OfALine) {
  const LineFit fit = line_fit(std::vector<Vec2>{{0, 1}, {1, 3}, {2, 5}});
  EXPECT_NEAR(fit.slope, 2, 1e-12);
  EXPECT_NEAR(fit.offset, 1, 1e-12);
  EXPECT_NEAR(fit.correlation, 1, 1e-12);
}

TEST(Histogram, WholeNumbersInANarrowRangeGetAClassEach) {
  const std::vector<Vec2> classes = histogram(std::vector<double>{3, 5, 5, kInfinity});
  ASSERT_EQ(classes.size(), 3u);
  EXPECT_EQ(classes[0].x, 3);
  EXPECT_EQ(classes[0].y, 1);
  EXPECT_EQ(classes[1].y, 0);
  EXPECT_EQ(classes[2].y, 2);
}

TEST(Histogram, HoldsEveryFiniteValueInAtMostTheClassesAsked) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(std::sqrt(i));
  double sum = 0;
  const std::vector<Vec2> classes = histogram(values, 17);
  for (const Vec2& c : classes) sum += c.y;
  EXPECT_EQ(sum, 1000);
  EXPECT_EQ(classes.size(), 17u);
  EXPECT_TRUE(histogram(std::vector<double>{}).empty());
  EXPECT_EQ(histogram(std::vector<double>{2.5, 2.5}).size(), 1u);
}

}  // namespace
}  // namespace cigsim
