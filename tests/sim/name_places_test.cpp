// SPDX-License-Identifier: MIT
// Names on a plot: however the points lie, none covers another or leaves the frame.
#include "sim/drawing/name_places.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cigsim {
namespace {

constexpr PixelBox kFrame{70, 40, 690, 440};

bool apart(const PixelBox& a, const PixelBox& b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

// Returns how many have a place.
std::size_t expect_legible(const std::vector<NamedMark>& names, const std::vector<Vec2>& marks,
                           const PixelBox& frame) {
  const auto places = place_names(names, marks, frame);
  EXPECT_EQ(places.size(), names.size());
  std::vector<PixelBox> boxes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const PixelBox& box = places[i]->box;
    EXPECT_NEAR(box.right - box.left, names[i].width, 1e-9);
    EXPECT_NEAR(box.bottom - box.top, names[i].height, 1e-9);
    EXPECT_TRUE(box.left >= frame.left && box.right <= frame.right && box.top >= frame.top &&
                box.bottom <= frame.bottom);
    for (const PixelBox& other : boxes) EXPECT_TRUE(apart(box, other)) << i;
    boxes.push_back(box);
  }
  return boxes.size();
}

TEST(NamePlaces, ManyNamesOfOnePlaceAllHaveRoom) {
  const std::vector<NamedMark> names(12, NamedMark{{300, 200}, 90, 12});
  EXPECT_EQ(expect_legible(names, std::vector<Vec2>(12, Vec2{300, 200}), kFrame), names.size());
}

TEST(NamePlaces, RandomPointsAreLegibleInEveryCorner) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    SCOPED_TRACE(trial);
    std::uniform_real_distribution<double> x(kFrame.left, kFrame.right),
        y(kFrame.top, kFrame.bottom), width(20, 140);
    std::vector<NamedMark> names;
    std::vector<Vec2> marks;
    for (int i = 0; i < 10; ++i) {
      names.push_back({{x(random), y(random)}, width(random), 12, i % 2 == 0});
      marks.push_back(names.back().at);
    }
    EXPECT_EQ(expect_legible(names, marks, kFrame), names.size());
  }
}

TEST(NamePlaces, ANameLiesBesideItsMarkUnlessAMarkIsThere) {
  const NamedMark name{{300, 200}, 60, 12, true};
  const std::vector<Vec2> alone{{300, 200}}, crowded{{300, 200}, {320, 200}};
  const auto right = place_names({&name, 1}, alone, kFrame).front();
  ASSERT_TRUE(right);
  EXPECT_FALSE(right->leader);
  EXPECT_GT(right->box.left, 300);
  EXPECT_DOUBLE_EQ((right->box.top + right->box.bottom) / 2, 200);
  const auto other = place_names({&name, 1}, crowded, kFrame).front();
  ASSERT_TRUE(other);
  EXPECT_TRUE(apart(other->box, {318, 198, 322, 202}));
}

TEST(NamePlaces, WhatIsLargerThanTheFrameIsLeftOut) {
  const NamedMark name{{5, 5}, 60, 12};
  EXPECT_EQ(expect_legible({name}, {{5, 5}}, {0, 0, 10, 10}), 0u);
}

}  // namespace
}  // namespace cigsim
