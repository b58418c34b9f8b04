// SPDX-License-Identifier: MIT
// The text of a budget, and what keeps one.
#include "sim/budget/budget.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

std::string message(const std::string& text) {
  try {
    parse_budget("--max-error", text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Budget, IsReadWithPercentOrShares) {
  const Budget budget = parse_budget("--max-error", "elements=0.1%,cycles=0,colour=0.02");
  EXPECT_EQ(budget.kind, Budget::Kind::kShares);
  EXPECT_DOUBLE_EQ(*budget.elements, 0.001);
  EXPECT_EQ(budget.cycles, 0.0);
  EXPECT_EQ(budget.colour, 0.02);
  EXPECT_EQ(parse_budget("--max-error", "none").kind, Budget::Kind::kNone);
  EXPECT_EQ(parse_budget("--max-error", "0").kind, Budget::Kind::kExact);
  EXPECT_FALSE(parse_budget("--max-error", "colour=1").elements);
}

TEST(Budget, IsRefusedInOneSentence) {
  EXPECT_NE(message("").find("must be none, 0, or shares"), std::string::npos);
  EXPECT_NE(message("1").find("must be none, 0, or shares"), std::string::npos);
  EXPECT_NE(message("elements=0.1%,").find("must be none, 0, or shares"), std::string::npos);
  EXPECT_NE(message("speed=1%").find("elements, cycles"), std::string::npos);
  EXPECT_EQ(message("elements=1%,elements=2%"), "--max-error: elements is named twice");
  for (const char* bad : {"-1%", "101%", "1.5", "", "%", "nan", "1e999", "0x1", "1 %"})
    EXPECT_NE(message(std::string("colour=") + bad).find("must be a share from 0 to 1"),
              std::string::npos)
        << bad;
}

TEST(Budget, IsKeptByErrorsUpToItsBounds) {
  const Budget budget = parse_budget("--max-error", "elements=10%,cycles=0");
  EXPECT_TRUE(keeps(budget, {0.1, 1, 0.0}));
  EXPECT_FALSE(keeps(budget, {0.11, 0, 0.0}));
  EXPECT_FALSE(keeps(budget, {0, 0, 1e-9}));
  EXPECT_FALSE(keeps(budget, {0, 0, {}})) << "cycles that are not known";
  EXPECT_TRUE(keeps(parse_budget("--max-error", "none"), {1, 1, {}}));
  EXPECT_TRUE(keeps(parse_budget("--max-error", "0"), {0, 0, {}}));
  EXPECT_FALSE(keeps(parse_budget("--max-error", "0"), {0, 1e-9, {}}));
}

TEST(Budget, ExcessIsBeyondOneExactlyWhereItIsNotKept) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const Budget budget = parse_budget("--max-error", "elements=10%,cycles=0");
  EXPECT_EQ(excess(budget, {0.1, 1, 0.0}), 1);
  EXPECT_DOUBLE_EQ(excess(budget, {0.3, 0, 0.0}), 3);
  EXPECT_EQ(excess(budget, {0, 0, 0.1}), kInfinite);
  EXPECT_EQ(excess(budget, {0, 0, {}}), kInfinite);
}

}  // namespace
}  // namespace cigsim
