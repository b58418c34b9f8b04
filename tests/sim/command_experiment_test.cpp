// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

TEST_F(CommandTest, ExperimentLevineWritesFiguresAndGraphs) {
  const Outcome outcome =
      cigsim({"experiment", "levine", "--cases", "2", "--only", "hull", "--out", "levine"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words : {"NT/NPTH", "cube-4", "Published, and ours"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
  EXPECT_EQ(files(), (std::vector<std::string>{
                         "levine", "levine/hull-group-1.svg", "levine/hull-group-2.svg",
                         "levine/hull-histograms.svg", "levine/levine.json"}));
  EXPECT_EQ(Json::parse(contents("levine/levine.json"))["hull"].size(), 8u);
}

TEST_F(CommandTest, ExperimentLevineAsJson) {
  const Outcome outcome =
      cigsim({"experiment", "levine", "--cases", "2", "--only", "sphere", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_EQ(r["cases"], 2);
  EXPECT_FALSE(r.contains("hull"));
  EXPECT_TRUE(files().empty());
}

TEST_F(CommandTest, ExperimentRefusesWhatItCannotUse) {
  expect_unusable({"experiment"}, "NAME");
  expect_unusable({"experiment", "fuchs"}, "choose from levine");
  expect_unusable({"experiment", "levine", "--cases", "0"}, "--cases");
  expect_unusable({"experiment", "levine", "--only", "cone"}, "--only");
  put("file", "");
  expect_unusable({"experiment", "levine", "--cases", "1", "--out", "file"}, "--out");
}

TEST_F(CommandTest, ExperimentAsksForGnuplotBeforeItMeasures) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  expect_unusable({"experiment", "levine", "--out", "levine"}, "gnuplot-nox");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace cigsim
