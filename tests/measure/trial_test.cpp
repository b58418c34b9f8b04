// SPDX-License-Identifier: MIT
// Settings measured in processes of their own: pictures as the machine gives them, cycles that
// agree between levels, and bad settings that must be found.
#include <gtest/gtest.h>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/machine/description.hpp"
#include "sim/measure/child.hpp"
#include "sim/measure/measure.hpp"
#include "sim/measure/reference.hpp"
#include "sim/scene.hpp"

namespace cigsim {
namespace {

constexpr Raster kRaster{96, 64};

std::vector<FrameView> airfield_views(const Database& database, std::size_t count) {
  ViewOptions options;
  options.path = "builtin";
  options.frames = count;
  return frame_views(options, load_path(options), database);
}

Setting setting(const std::string& name, NumberType number) {
  Setting s;
  s.name = name;
  s.machine.number = number;
  s.machine.raster = kRaster;
  s.machine.description = with_raster(machine_preset("unlimited"), kRaster);
  return s;
}

Setting at_level(const std::string& level) {
  Setting s = setting(level, NumberType::kMachine);
  s.levels = LevelChoice::parse(level);
  s.machine.resolver = ResolverMethod::kActiveList;
  return s;
}

class Trials : public testing::Test {
 protected:
  LoadedScene scene_ = load_scene({}, {});
  Workload work_{&scene_.database, airfield_views(scene_.database, 3), nullptr};
  std::vector<ReferencePicture> references_ =
      reference_pictures(scene_.database, work_.views, kRaster);
  MeasureOptions options_{.rounds = 2, .seed = 1, .limit_s = 300, .progress = {}};

  void SetUp() override { work_.references = &references_; }
};

TEST_F(Trials, ExactIsWithoutErrorAndDoubleNearlySo) {
  const auto results =
      measure({setting("exact", NumberType::kExact), setting("double", NumberType::kDouble)}, work_,
              options_);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].error().wrong, 0u);
  EXPECT_EQ(results[0].error().colour_sum, 0u);
  EXPECT_EQ(results[0].error().elements, 3u * 96u * 64u);
  EXPECT_LT(results[1].error().share(), 1e-4);
  for (const Measured& result : results) {
    EXPECT_GT(result.frame_ms.median, 0);
    EXPECT_GE(result.memory_mib.median, 0);
    EXPECT_TRUE(result.delays.empty());
    EXPECT_FALSE(result.given_up);
  }
}

// The planted bad case: coordinates of 16 bits, quotients of 8, places to a sixteenth.
TEST_F(Trials, AMachineWordTooNarrowShowsWrongElements) {
  Setting wide = setting("wide", NumberType::kMachine), narrow = wide;
  narrow.name = "narrow";
  narrow.machine.description.formats = {16, 12, 8, 4};
  const auto results = measure({wide, narrow}, work_, options_);
  EXPECT_LT(results[0].error().share(), 0.01);
  EXPECT_GT(results[1].error().wrong, 10 * (results[0].error().wrong + 1));
}

TEST_F(Trials, LevelsThatKnowTimeAgreeInCyclesAndPictures) {
  const auto results =
      measure({at_level("timed"), at_level("clocked"), at_level("video_processor=clocked"),
               setting("words", NumberType::kMachine)},
              work_, options_);
  ASSERT_EQ(results[0].delays.size(), 3u);
  for (const std::size_t other : {1u, 2u}) {
    EXPECT_EQ(results[other].delays, results[0].delays) << results[other].setting.name;
    EXPECT_EQ(cycle_error(results[other].delays, results[0].delays), 0.0);
  }
  for (const Measured& result : results)
    EXPECT_EQ(result.errors, results[0].errors) << result.setting.name;
  EXPECT_GT(results[0].mcycles_per_second.median, 0);
  EXPECT_EQ(results[3].mcycles_per_second.median, 0);
}

TEST_F(Trials, WhatTakesTooLongIsGivenUpAndTheRestGoesOn) {
  options_.limit_s = 1e-9;
  const auto results = measure({setting("exact", NumberType::kExact)}, work_, options_);
  EXPECT_EQ(results[0].given_up, "exact: not done within 1e-09 s");
}

TEST_F(Trials, ASettingThatFailsIsNamedAndTheRestGoesOn) {
  Setting bad = setting("no raster", NumberType::kDouble);
  bad.machine.raster = {0, 1};
  const auto results = measure({bad, setting("double", NumberType::kDouble)}, work_, options_);
  EXPECT_EQ(results[0].given_up, "no raster: raster: width and height must lie in 1..16384");
  EXPECT_FALSE(results[1].given_up);
  EXPECT_GT(results[1].frame_ms.median, 0);
}

TEST_F(Trials, AnEmptySceneIsMeasured) {
  Environment environment;
  environment.systems.resize(1);
  const Database empty = prepare(environment, {});
  work_.database = &empty;
  work_.views.resize(1);
  references_ = reference_pictures(empty, work_.views, kRaster);
  for (const Measured& result :
       measure({setting("float", NumberType::kFloat), at_level("timed")}, work_, options_))
    EXPECT_EQ(result.error().wrong, 0u);
}

TEST(CycleError, IsTheWorstShare) {
  EXPECT_EQ(cycle_error({100, 220}, {100, 200}), 0.1);
  EXPECT_EQ(cycle_error({90}, {100}), 0.1);
  EXPECT_EQ(cycle_error({}, {}), std::nullopt);
  EXPECT_EQ(cycle_error({1}, {}), std::nullopt);
  EXPECT_EQ(cycle_error({0}, {0}), 0.0);
}

}  // namespace
}  // namespace cigsim
