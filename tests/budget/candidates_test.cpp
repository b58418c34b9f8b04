// SPDX-License-Identifier: MIT
// Which settings a budget chooses from.
#include "sim/budget/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

bool any_of(const std::vector<Setting>& settings, NumberType number) {
  return std::any_of(settings.begin(), settings.end(),
                     [number](const Setting& s) { return s.machine.number == number; });
}

TEST(Candidates, FloatsOnlyWhereTheyAreAllowed) {
  const Budget budget = parse_budget("--max-error", "elements=1%");
  CandidateRange range;
  EXPECT_TRUE(any_of(candidates(budget, range), NumberType::kFloat));
  range.floats = false;
  EXPECT_FALSE(any_of(candidates(budget, range), NumberType::kFloat));
  EXPECT_TRUE(any_of(candidates(budget, range), NumberType::kDouble));
}

TEST(Candidates, HaveNamesOfTheirOwn) {
  CandidateRange range;
  range.choices = true;
  std::set<std::string> names;
  const auto all = candidates(parse_budget("--max-error", "elements=1%,cycles=0"), range);
  for (const Setting& setting : all) names.insert(setting.name);
  EXPECT_EQ(names.size(), all.size());
}

TEST(Candidates, ProvedPicturesAreCertifiedAndNoMachineHasThem) {
  const Budget exact = parse_budget("--max-error", "0");
  CandidateRange range;
  for (const Setting& setting : candidates(exact, range))
    EXPECT_EQ(setting.machine.number, NumberType::kCertified);
  range.machine_given = true;
  EXPECT_THROW(candidates(exact, range), UsageError);
}

}  // namespace
}  // namespace cigsim
