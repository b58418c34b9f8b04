// SPDX-License-Identifier: MIT
// Stump's thresholds at their extremes.
#include "sim/stability/published_thresholds.hpp"

#include <gtest/gtest.h>

namespace cigsim::stability {
namespace {

const std::vector<ThresholdPoint>& points() {
  static const std::vector<ThresholdPoint> all = [] {
    ThresholdOptions options;
    options.decks = 3;
    return measure_thresholds(options);
  }();
  return all;
}

const ThresholdPoint& at(ThresholdAxis axis, double value) {
  for (const ThresholdPoint& p : points())
    if (p.axis == axis && p.value == value) return p;
  throw std::out_of_range("no such value");
}

TEST(PublishedThresholds, HisProgramIsRightAtHisScale) {
  for (const double scale : {1.0, 1e2, 1e4}) {
    const ThresholdPoint& p = at(ThresholdAxis::kScale, scale);
    EXPECT_EQ(p.wrong(), 0u);
    EXPECT_EQ(p.own_cut, 0u);
    EXPECT_EQ(p.right, p.decks);
    EXPECT_GT(p.decisions, 0u);
  }
}

TEST(PublishedThresholds, AThousandthAsLargeItsTablesAreWrongAndNobodyIsTold) {
  const ThresholdPoint& p = at(ThresholdAxis::kScale, 1e-3);
  EXPECT_GT(p.missed_cuts, 0u);
  EXPECT_GT(p.found, p.right);
}

TEST(PublishedThresholds, BelowTheToleranceNothingIsFound) {
  for (const double scale : {1e-12, 1e-6, 1e-5}) {
    const ThresholdPoint& p = at(ThresholdAxis::kScale, scale);
    EXPECT_GT(p.wrong(), p.decisions / 2);
    EXPECT_EQ(p.own_cut, p.faces);
    EXPECT_EQ(p.found, 0u);
  }
}

TEST(PublishedThresholds, FirstThreeVerticesThatDrawTogetherTiltThePlane) {
  EXPECT_EQ(at(ThresholdAxis::kSliver, 1).own_cut, 0u);
  EXPECT_GT(at(ThresholdAxis::kSliver, 1e-7).own_cut, 0u);
  EXPECT_LT(at(ThresholdAxis::kSliver, 1e-5).right, at(ThresholdAxis::kSliver, 1e-5).found);
  EXPECT_GT(at(ThresholdAxis::kSliver, 1e-10).refused, 0u);
}

TEST(PublishedThresholds, ExactSidesAreRightEverywhere) {
  for (const ThresholdPoint& p : points()) {
    EXPECT_EQ(p.exact_found, p.decks) << name_of(p.axis) << " " << p.value;
    EXPECT_EQ(p.exact_right, p.decks) << name_of(p.axis) << " " << p.value;
  }
}

TEST(PublishedThresholds, ADeckOfOneObjectIsRefused) {
  ThresholdOptions options;
  options.objects = 1;
  EXPECT_THROW(measure_thresholds(options), std::invalid_argument);
}

}  // namespace
}  // namespace cigsim::stability
