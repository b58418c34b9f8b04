// SPDX-License-Identifier: MIT
#include "models/database/bsp/bounds.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

TEST(Combinations, SmallOnes) {
  EXPECT_EQ(combinations(0, 0), 1u);
  EXPECT_EQ(combinations(3, 0), 1u);
  EXPECT_EQ(combinations(5, 2), 10u);
  EXPECT_EQ(combinations(3, 3), 1u);
  EXPECT_EQ(combinations(2, 3), 0u);
  EXPECT_EQ(combinations(100000, 3), 166661666700000u);
}

TEST(MostVolumes, OfOneDimensionAreIntervals) { EXPECT_EQ(most_volumes(1, 7), 8u); }

}  // namespace
}  // namespace cigsim
