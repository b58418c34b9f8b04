// SPDX-License-Identifier: MIT
// Sampled and held-back frames of runs of every length.
#include "sim/budget/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cigsim {
namespace {

bool strictly_ascending(const std::vector<std::size_t>& v) {
  return std::adjacent_find(v.begin(), v.end(), std::greater_equal<>()) == v.end();
}

TEST(SampleFrames, AreApartSpreadAndWithinTheRun) {
  for (std::size_t most = 1; most <= 6; ++most)
    for (std::size_t frames = 1; frames <= 200; ++frames) {
      SCOPED_TRACE(testing::Message() << frames << " frames, at most " << most);
      const FrameSample sample = sample_frames(frames, most);
      EXPECT_EQ(sample.sampled.size(), std::min(most, (frames + 1) / 2));
      EXPECT_EQ(sample.held_back.size(), std::min(most, frames - sample.sampled.size()));
      EXPECT_TRUE(strictly_ascending(sample.sampled));
      EXPECT_TRUE(strictly_ascending(sample.held_back));
      std::set<std::size_t> all(sample.sampled.begin(), sample.sampled.end());
      all.insert(sample.held_back.begin(), sample.held_back.end());
      EXPECT_EQ(all.size(), sample.sampled.size() + sample.held_back.size());
      EXPECT_LT(*all.rbegin(), frames);
      EXPECT_EQ(sample.sampled.front(), 0u);
      EXPECT_TRUE(sample.sampled.size() == 1 || sample.sampled.back() == frames - 1);
    }
}

TEST(SampleFrames, OfTen) {
  const FrameSample sample = sample_frames(10, 5);
  EXPECT_EQ(sample.sampled, (std::vector<std::size_t>{0, 2, 5, 7, 9}));
  EXPECT_EQ(sample.held_back, (std::vector<std::size_t>{1, 3, 4, 6, 8}));
}

}  // namespace
}  // namespace cigsim
