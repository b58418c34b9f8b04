// SPDX-License-Identifier: MIT
#include "sim/stats.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

TEST(Stats, MedianIsTheMiddleOrTheMeanOfTwo) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({9, 1, 5, 6}), 5.5);
}

TEST(Stats, RepeatsGiveMediansOfEachTime) {
  std::vector<FrameStats> repeats(3);
  for (std::size_t i = 0; i < 3; ++i) {
    repeats[i].host_ms = i == 0 ? 100 : static_cast<double>(i);
    repeats[i].stages.video_processor = i == 1 ? 50 : static_cast<double>(i);
    repeats[i].spans = 7;
  }
  const FrameStats stats = median_times(repeats);
  EXPECT_EQ(stats.host_ms, 2);
  EXPECT_EQ(stats.stages.video_processor, 2);
  EXPECT_EQ(stats.spans, 7u);
}

TEST(Stats, NumbersThatThePictureOfNumbersCannotHoldAreSaid) {
  Database database;
  database.object_count = 65534;
  database.ground.faces.resize(1);
  EXPECT_FALSE(numbers_saturate(database));
  database.ground.faces.resize(2);
  EXPECT_TRUE(numbers_saturate(database));
}

TEST(Stats, NamesThatAreNotTextDoNotStopTheOutput) {
  EXPECT_NE(dump({{"name", "\xff"}}).find("name"), std::string::npos);
}

}  // namespace
}  // namespace cigsim
