// SPDX-License-Identifier: MIT
// Levine's measurements with few cases: all quantities are there, the same seed gives the same
// figures, and those that hold on average already hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "models/environment/read.hpp"
#include "sim/experiments/levine_json.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

ExperimentOptions few(std::uint64_t seed) {
  ExperimentOptions options;
  options.cases = 6;
  options.seed = seed;
  return options;
}

LevineResults results_of(std::uint64_t seed) {
  const Environment city =
      read_environment(std::filesystem::path(CIGSIM_SOURCE_DIR) / "scenes/levine-city.json")
          .environment;
  const ExperimentOptions options = few(seed);
  return {options, run_hull_experiment(options), run_sphere_experiment(options),
          run_hidden_line_experiment(options, city, 30)};
}

const LevineResults& shared_results() {
  static const LevineResults results = results_of(1);
  return results;
}

// Without what depends on the host.
Json timeless(Json json) {
  if (json.is_object()) {
    json.erase("seconds");
    json.erase("ms");
    if (json.contains("timed") && json["timed"] == true) return nullptr;
  }
  if (json.is_structured())
    for (Json& value : json) value = timeless(value);
  return json;
}

double finding(const std::string& beginning) {
  for (const Finding& f : levine_findings(shared_results()))
    if (f.what.starts_with(beginning)) return f.ours;
  ADD_FAILURE() << beginning;
  return 0;
}

TEST(LevineExperiment, HoldsEveryQuantityOfEveryDataSet) {
  const Json json = levine_json(shared_results());
  ASSERT_EQ(json["hull"].size(), 8u);
  ASSERT_EQ(json["sphere"].size(), 8u);
  ASSERT_EQ(json["hidden_line"].size(), 8u);
  std::size_t sets = 0;
  for (std::size_t d = 0; d < 8; ++d)
    for (const Json& set : json["hull"][d]["sets"]) {
      ++sets;
      EXPECT_EQ(set["cases"], 6);
      for (const auto& q : kHullQuantities) EXPECT_GT(set[q.key]["mean"], 0) << q.key;
    }
  EXPECT_EQ(sets, 3 * 8 + 7 + 3 * 6 + 7);
  for (const Json& curve : json["sphere"])
    for (const Json& set : curve["sets"])
      for (const auto& q : kSphereQuantities)
        EXPECT_EQ(set[q.key].size(), kSphereShares.size()) << q.key;
  for (const Json& set : json["hidden_line"])
    for (const auto& c : kHiddenLineCounters) {
      EXPECT_EQ(set["yaw"][c.key].size(), 12u);
      EXPECT_EQ(set["pitch"][c.key].size(), 12u);
      EXPECT_GT(set["averages"][c.key], 0) << c.key;
    }
}

TEST(LevineExperiment, SameSeedGivesTheSameFigures) {
  const Json json = timeless(levine_json(shared_results()));
  EXPECT_EQ(json, timeless(levine_json(results_of(1))));
  EXPECT_NE(json, timeless(levine_json(results_of(2))));
}

TEST(LevineAppendix1, HullPointsFollowHisExponents) {
  EXPECT_NEAR(finding("hull points against points, cube 1"), 0.29, 0.05);
  EXPECT_NEAR(finding("hull points against points, cube 4"), 0.20, 0.05);
}

TEST(LevineAppendix1, TestsPerHullPointGrowByThePowerThreeQuarters) {
  EXPECT_NEAR(finding("NT/NPTH against points"), 0.75, 0.06);
  EXPECT_NEAR(finding("NEQ/NPTH against points"), 1, 0.05);
}

TEST(LevineAppendix1, AnOrderOfMagnitudeFewerTestsThanChandAndKapur) {
  const double ratio = finding("NEQ/NT");
  EXPECT_GT(ratio, 7);
  EXPECT_LT(ratio, 14);
}

TEST(LevineAppendix2, EllipseNeedsOneSphereInsteadOfTenMillion) {
  EXPECT_EQ(finding("ellipse, 1600 points, 50 %: NSC"), 1);
  EXPECT_NEAR(finding("ellipse, 1600 points, 50 %: log10 of ESC"), 7, 0.6);
}

TEST(LevineAppendix2, FirstPointIsOnTheSphereOfCube1InHalfOfTheCases) {
  EXPECT_EQ(finding("cube 1, 50 %: first selected point"), 1);
}

TEST(LevineAppendix3, DataSetsAreHisInObjectsAndEdges) {
  const std::vector<std::pair<std::size_t, std::size_t>> expected{
      {4, 48}, {8, 96}, {16, 192}, {24, 288}, {32, 384}, {48, 576}, {16, 192}, {32, 384}};
  ASSERT_EQ(shared_results().hidden_line.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(shared_results().hidden_line[i].objects, expected[i].first);
    EXPECT_EQ(shared_results().hidden_line[i].edges, expected[i].second);
  }
}

// Every intersection that happens was computed; a set is as hard from the front as from the back.
TEST(LevineAppendix3, CountersAreConsistent) {
  for (const HiddenLineDataSet& set : shared_results().hidden_line)
    for (const auto* frames : {&set.yaw, &set.pitch})
      for (const HiddenLineFrame& frame : *frames) {
        EXPECT_LE(frame.counters.actual_intersections, frame.counters.intersections_computed);
        EXPECT_LE(frame.counters.objects_in_window, frame.counters.objects_considered);
        EXPECT_LE(frame.counters.edges_displayed, set.edges);
        EXPECT_LE(frame.counters.front_faces, set.edges / 2);
      }
}

}  // namespace
}  // namespace cigsim
