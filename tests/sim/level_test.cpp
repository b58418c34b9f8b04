// SPDX-License-Identifier: MIT
#include "sim/level.hpp"

#include <gtest/gtest.h>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

TEST(Levels, OneWordIsForAllStages) {
  const LevelChoice timed = LevelChoice::parse("timed");
  for (const Stage stage : kAllStages) EXPECT_EQ(timed[stage], Level::kTimed);
  EXPECT_EQ(timed.text(), "timed");
  EXPECT_TRUE(LevelChoice::parse("functional").functional());
}

TEST(Levels, AStageWithoutTheLevelTakesTheNearestSimplerOne) {
  const LevelChoice clocked = LevelChoice::parse("clocked");
  EXPECT_EQ(clocked[Stage::kFrameCalculator], Level::kTimed);
  EXPECT_EQ(clocked[Stage::kVideoProcessor], Level::kClocked);
  EXPECT_EQ(clocked.text(), "clocked");
  const LevelChoice rtl = LevelChoice::parse("rtl");
  EXPECT_EQ(rtl[Stage::kFrameCalculator], Level::kTimed);
  EXPECT_EQ(rtl[Stage::kGeometryProcessor], Level::kClocked);
  EXPECT_EQ(rtl[Stage::kPriorityProcessor], Level::kRtl);
  EXPECT_EQ(rtl.text(), "rtl");
}

TEST(Levels, NamedStagesStandAmongTimedOnes) {
  const LevelChoice mix = LevelChoice::parse("geometry_processor=clocked,priority_processor=timed");
  EXPECT_EQ(mix[Stage::kGeometryProcessor], Level::kClocked);
  EXPECT_EQ(mix[Stage::kPriorityProcessor], Level::kTimed);
  EXPECT_EQ(mix[Stage::kEdgeOrderer], Level::kTimed);
  EXPECT_EQ(mix.text(), "geometry_processor=clocked");
  EXPECT_EQ(LevelChoice::parse(mix.text()), mix);
}

TEST(Levels, WhatDoesNotExistIsRefused) {
  for (const char* text :
       {"", "slow", "clocked,", "frame_calculator=clocked", "video_processor=rtl", "painter=timed",
        "edge_orderer", "edge_orderer=timed,", "edge_orderer=functional", "edge_orderer==timed",
        "edge_orderer=timed,edge_orderer=clocked"}) {
    EXPECT_THROW(LevelChoice::parse(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace cigsim
