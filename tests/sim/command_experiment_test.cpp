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

TEST_F(CommandTest, ExperimentReplacesThePlotsOfAnEarlierOneAndNothingElse) {
  std::filesystem::create_directories(folder_ / "levine/deep");
  const std::vector<std::string> kept{"mine.svg", "levine/hidden-line.svg", "levine/deep/b.svg",
                                      "levine/notes.txt"};
  for (const std::string& file : kept) put(file, "of the user");
  const auto run = [&](const char* part) {
    const Outcome outcome =
        cigsim({"experiment", "levine", "--cases", "2", "--only", part, "--out", "levine"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  run("hull");
  Json figures = Json::parse(contents("levine/levine.json"));
  for (const char* strange : {"../mine.svg", "deep/b.svg", "notes.txt", "deep", ""})
    figures["plots"].push_back(strange);
  figures["plots"].push_back(3);
  put("levine/levine.json", figures.dump());
  run("sphere");
  for (const std::string& file : kept) EXPECT_EQ(contents(file), "of the user") << file;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "levine/hull-group-1.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "levine/sphere-group-1.svg"));

  // Figures of anything else list nothing that could be removed.
  for (const char* others : {R"({"plots": ["notes.svg"]})", R"(["notes.svg"])", "no JSON",
                             R"({"experiment": "growth", "plots": ["notes.svg"]})"}) {
    put("levine/levine.json", others);
    put("levine/notes.svg", "of the user");
    run("sphere");
    EXPECT_EQ(contents("levine/notes.svg"), "of the user") << others;
  }
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
