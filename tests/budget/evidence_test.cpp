// SPDX-License-Identifier: MIT
// Which setting a budget takes, worked by hand.
#include "sim/budget/evidence.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

Evidence evidence(const std::string& name, double ms, double elements, double colour,
                  std::optional<double> cycles = {}) {
  Evidence e;
  e.name = name;
  e.frame_ms = {ms, ms * 0.9, ms * 1.1};
  e.worst = {elements, colour, cycles};
  return e;
}

const std::vector<Evidence> kAll{evidence("float", 1, 0.02, 0.01), evidence("double", 2, 0.001, 0),
                                 evidence("certified", 3, 0, 0),
                                 evidence("timed", 10, 0.002, 0.001, 0.0)};

std::string chosen(const std::string& text, const std::vector<Evidence>& all = kAll) {
  const auto i = choose(parse_budget("--max-error", text), all);
  return i ? all[*i].name : "nothing";
}

TEST(Choose, TakesTheFastestThatKeepsTheBudget) {
  EXPECT_EQ(chosen("none"), "float");
  EXPECT_EQ(chosen("0"), "certified");
  EXPECT_EQ(chosen("elements=2%"), "float");
  EXPECT_EQ(chosen("elements=1%"), "double");
  EXPECT_EQ(chosen("elements=2%,colour=0"), "double");
  EXPECT_EQ(chosen("elements=0"), "certified");
  EXPECT_EQ(chosen("cycles=0"), "timed");
  EXPECT_EQ(chosen("cycles=0,elements=0.2%"), "timed");
  EXPECT_EQ(chosen("cycles=0,elements=0.1%"), "nothing");
}

TEST(Choose, LeavesOutWhatCouldNotBeMeasured) {
  std::vector<Evidence> all = kAll;
  all[0].measured = false;
  EXPECT_EQ(chosen("none", all), "double");
  for (Evidence& one : all) one.measured = false;
  EXPECT_EQ(chosen("none", all), "nothing");
}

TEST(Choose, KnowsTheSecond) {
  const Budget budget = parse_budget("--max-error", "elements=1%");
  EXPECT_EQ(second(budget, kAll, 1), 2u);
  EXPECT_EQ(second(parse_budget("--max-error", "cycles=0"), kAll, 3), std::nullopt);
}

TEST(Nearest, NamesThoseThatMissLeast) {
  const std::string text =
      nearest_text(parse_budget("--max-error", "cycles=0,elements=0.1%"), kAll);
  EXPECT_EQ(text,
            "timed (elements 0.2 %, cycles 0), certified (elements 0, cycles not known), double "
            "(elements 0.1 %, cycles not known)");
}

TEST(Evidence, SurvivesJson) {
  for (const Evidence& one : kAll) EXPECT_EQ(evidence_from_json(evidence_json(one)), one);
}

}  // namespace
}  // namespace cigsim
