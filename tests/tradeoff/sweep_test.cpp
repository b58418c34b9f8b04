// SPDX-License-Identifier: MIT
// Every knob is turned, alone, and no two points are the same.
#include "sim/tradeoff/sweep.hpp"

#include <gtest/gtest.h>

#include <set>

namespace cigsim {
namespace {

SweepRange range() {
  SweepRange r;
  r.raster = {640, 480};
  r.description = with_raster(machine_preset("unlimited"), r.raster);
  r.levels = {kAllLevels.begin(), kAllLevels.end()};
  return r;
}

TEST(Sweep, BeginsWithTheDefaultAndHasNoTwoAlike) {
  const std::vector<SweepPoint> points = sweep(range());
  EXPECT_EQ(points.front().knob, "default");
  std::set<std::string> names, settings;
  for (const SweepPoint& point : points) {
    EXPECT_TRUE(names.insert(point.setting.name).second) << point.setting.name;
    EXPECT_TRUE(settings.insert(setting_json(point.setting).dump()).second) << point.setting.name;
  }
}

TEST(Sweep, TurnsEveryKnob) {
  std::set<std::string> knobs;
  for (const SweepPoint& point : sweep(range())) knobs.insert(point.knob);
  EXPECT_EQ(knobs,
            (std::set<std::string>{"coherence", "default", "detail", "level", "number", "priority",
                                   "raster", "resolver", "retrieval", "together", "words"}));
}

TEST(Sweep, OneKnobChangesWhatItIsNamedAfter) {
  const std::vector<SweepPoint> points = sweep(range());
  const auto base = setting_json(points.front().setting);
  for (const SweepPoint& point : points) {
    if (!base.contains(point.knob)) continue;
    const auto changed = setting_json(point.setting);
    if (point.setting.machine.number == NumberType::kMachine) continue;
    for (const auto& [key, value] : base.items())
      EXPECT_EQ(changed[key] == value, key != point.knob) << point.setting.name << ": " << key;
  }
}

TEST(Sweep, LeavesOutWhatTheSceneAndTheLevelsDoNotHave) {
  SweepRange r = range();
  r.choices = false;
  r.levels = {Level::kTimed};
  for (const SweepPoint& point : sweep(r)) {
    EXPECT_NE(point.knob, "detail");
    EXPECT_EQ(point.setting.levels.functional(), point.knob == "default");
  }
  EXPECT_EQ(sweep(r).size(), 2u);
}

TEST(Sweep, RastersStayWithinWhatCigsimCanHave) {
  SweepRange r = range();
  r.raster = {16384, 1};
  for (const SweepPoint& point : sweep(r)) {
    EXPECT_LE(point.setting.machine.raster.width, 16384);
    EXPECT_GE(point.setting.machine.raster.height, 1);
  }
  r.raster = {3, 2};  // has a half, but no quarter
  for (const SweepPoint& point : sweep(r)) EXPECT_FALSE(point.setting.name.ends_with("raster 1/4"));
}

}  // namespace
}  // namespace cigsim
