// SPDX-License-Identifier: MIT
// The order of measurements, and what they come to.
#include "sim/measure/interleave.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cigsim {
namespace {

TEST(Interleaved, EachRoundHasEachOnce) {
  const std::vector<std::size_t> order = interleaved(7, 5, 3);
  ASSERT_EQ(order.size(), 35u);
  std::set<std::vector<std::size_t>> rounds;
  for (std::size_t round = 0; round < 5; ++round) {
    std::vector<std::size_t> part(order.begin() + static_cast<std::ptrdiff_t>(7 * round),
                                  order.begin() + static_cast<std::ptrdiff_t>(7 * round + 7));
    rounds.insert(part);
    std::sort(part.begin(), part.end());
    EXPECT_EQ(part, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6}));
  }
  EXPECT_GT(rounds.size(), 1u);
}

TEST(Interleaved, TheSeedDecides) {
  EXPECT_EQ(interleaved(10, 3, 1), interleaved(10, 3, 1));
  EXPECT_NE(interleaved(10, 3, 1), interleaved(10, 3, 2));
  EXPECT_TRUE(interleaved(0, 3, 1).empty());
}

TEST(Interleaved, EveryPlaceIsAsLikely) {
  // 6,000 rounds of 4: each of the 16 pairs of thing and place is expected 1,500 times, with a
  // standard deviation of 34.
  const std::vector<std::size_t> order = interleaved(4, 6000, 1);
  std::array<std::array<int, 4>, 4> counts{};
  for (std::size_t i = 0; i < order.size(); ++i) ++counts[i % 4][order[i]];
  for (const auto& place : counts)
    for (const int count : place) EXPECT_NEAR(count, 1500, 170);
}

TEST(Spread, OfKnownValues) {
  const Spread five = spread({5, 1, 4, 2, 3});
  EXPECT_EQ(five.median, 3);
  EXPECT_EQ(five.low, 2);
  EXPECT_EQ(five.high, 4);
  const Spread two = spread({2, 1});
  EXPECT_EQ(two.median, 1.5);
  EXPECT_EQ(two.low, 1.25);
  EXPECT_EQ(two.high, 1.75);
  EXPECT_EQ(spread({7}).high, 7);
  EXPECT_EQ(spread({}).median, 0);
}

}  // namespace
}  // namespace cigsim
