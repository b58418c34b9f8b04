// SPDX-License-Identifier: MIT
#include "sim/timeline_picture.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

FrameTiming picture(Cycle input) {
  FrameTiming timing;
  timing.input = input;
  timing.first_element = input + 2100;
  timing.last_element = input + 2999;
  timing.period = {1000, 1000, 1000};
  for (std::size_t s = 0; s < kStageCount; ++s) {
    const Cycle frame = s == 0 ? 0 : s < 3 ? 1000 : 2000;
    timing.activity[s] = {input + frame + 1, input + frame + 900, 10, 5};
  }
  return timing;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Timeline, HasABarAPictureAndStage) {
  const std::string svg = timeline_svg({picture(0), picture(1000), picture(2000)}, 125);
  EXPECT_EQ(count(svg, "<title>"), 3 * kStageCount);
  EXPECT_NE(svg.find("picture 1: cycles 1001 to 1900; 885 busy, 10 idle, 5 stalled"),
            std::string::npos);
  EXPECT_NE(svg.find("3000 cycles, 0.4 ms"), std::string::npos);
  for (const Stage stage : kAllStages)
    EXPECT_NE(svg.find(std::string(name_of(stage))), std::string::npos);
}

TEST(Timeline, LongRunsShowTheFirstFourPictures) {
  std::vector<FrameTiming> pictures;
  for (int p = 0; p < 10; ++p) pictures.push_back(picture(1000 * p));
  EXPECT_EQ(count(timeline_svg(pictures, 125), "<title>"), 4 * kStageCount);
}

TEST(Timeline, AMachineOfOneCycleStillHasAnAxis) {
  FrameTiming tiny;
  EXPECT_NE(timeline_svg({tiny}, 1).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace cigsim
