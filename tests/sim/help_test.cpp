// SPDX-License-Identifier: MIT
#include "sim/commands/help.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

TEST(Help, LinesBreakAtBlanks) {
  EXPECT_EQ(wrapped("", 5), "");
  EXPECT_EQ(wrapped("one two", 7), "one two");
  EXPECT_EQ(wrapped("one two", 6), "one\ntwo");
  EXPECT_EQ(wrapped("a longword b", 4), "a\nlongword\nb");
}

}  // namespace
}  // namespace cigsim
