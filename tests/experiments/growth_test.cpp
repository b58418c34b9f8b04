// SPDX-License-Identifier: MIT
#include "sim/experiments/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/database/prepare.hpp"
#include "sim/experiments/crowded_city.hpp"
#include "sim/experiments/growth_json.hpp"
#include "sim/experiments/growth_sweeps.hpp"

namespace cigsim {
namespace {

GrowthCurve curve_of(double power, ExpectedExponent expected, bool timed = false) {
  GrowthCurve curve;
  curve.timed = timed;
  curve.expected = expected;
  for (double x = 10; x <= 1e4; x *= 10) {
    const double y = 3 * std::pow(x, power);
    curve.points.push_back({x, {y, y, y}});
  }
  return curve;
}

TEST(Growth, AWrongExponentIsFound) {
  EXPECT_TRUE(curve_of(1, {1, 0.9, 1.1}).as_expected());
  EXPECT_FALSE(curve_of(1.5, {1, 0.9, 1.1}).as_expected());
  EXPECT_FALSE(curve_of(0.5, {1, 0.9, 1.1}).as_expected());
  GrowthResults results;
  results.curves = {curve_of(1, {1, 0.9, 1.1}), curve_of(2, {1, 0.9, 1.1}, true)};
  EXPECT_TRUE(results.good()) << "times are the host's";
  EXPECT_FALSE(growth_json(results)["curves"][1]["host"]["as_expected"].get<bool>());
  results.curves.push_back(curve_of(2, {1, 0.9, 1.1}));
  EXPECT_FALSE(results.good());
  EXPECT_FALSE(growth_json(results)["good"].get<bool>());
  EXPECT_FALSE(growth_json(results)["curves"][2]["counted"]["as_expected"].get<bool>());
}

TEST(Growth, WithoutTwoPointsThereIsNoExponent) {
  GrowthCurve curve = curve_of(1, {1, 0.9, 1.1});
  curve.points.resize(1);
  EXPECT_FALSE(curve.as_expected());
  GrowthResults results;
  results.curves = {curve};
  EXPECT_TRUE(growth_json(results)["curves"][0]["counted"]["exponent"].is_null());
}

GrowthSubject crowd(std::uint32_t objects, std::uint64_t seed) {
  const CrowdedCity city = make_crowded_city(10, objects, seed);
  GrowthSubject subject;
  subject.database = std::make_shared<Database>(prepare(city.environment));
  subject.viewpoint = city.viewpoint;
  return subject;
}

// Planted: another city, another eye.
TEST(Growth, AnotherPictureIsFound) {
  std::vector<GrowthSubject> subjects{crowd(10, 1), crowd(30, 1), crowd(100, 1)};
  EXPECT_TRUE(same_views(subjects, 10));
  subjects[2].viewpoint.eye.position.z += 1;
  EXPECT_FALSE(same_views(subjects, 10));
  subjects[2] = crowd(100, 2);
  EXPECT_FALSE(same_views(subjects, 10));
  GrowthResults results;
  EXPECT_TRUE(results.good());
  results.same_pictures = false;
  EXPECT_FALSE(results.good());
}

TEST(Growth, QuickSweepsCountWhatTheoryCounts) {
  GrowthOptions options;
  options.quick = true;
  const GrowthResults results = run_growth(options);
  EXPECT_TRUE(results.good());
  EXPECT_TRUE(results.same_pictures);
  std::size_t counted = 0;
  for (const GrowthCurve& curve : results.curves) {
    SCOPED_TRACE(curve.key);
    EXPECT_GE(curve.points.size(), 3u);
    EXPECT_FALSE(curve.why.empty());
    for (std::size_t i = 1; i < curve.points.size(); ++i)
      EXPECT_GT(curve.points[i].x, curve.points[i - 1].x);
    if (curve.timed) continue;
    ++counted;
    EXPECT_TRUE(curve.as_expected()) << curve.fit().exponent;
  }
  EXPECT_GE(counted, 6u);
}

TEST(CrowdedCity, OnlyTheFirstAreInView) {
  const CrowdedCity small = make_crowded_city(10, 10, 4), large = make_crowded_city(10, 400, 4);
  ASSERT_EQ(large.environment.objects.size(), 400u);
  MachineOptions options;
  options.raster = {128, 128};
  const Database a = prepare(small.environment), b = prepare(large.environment);
  EXPECT_EQ(FunctionalMachine(a, options).compute(small.viewpoint, 0).colours,
            FunctionalMachine(b, options).compute(large.viewpoint, 0).colours);
  EXPECT_GT(database_bytes(b), 30 * database_bytes(a));
}

}  // namespace
}  // namespace cigsim
