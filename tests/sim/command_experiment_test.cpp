// SPDX-License-Identifier: MIT
#include <sys/stat.h>

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
  figures["plots"].push_back(std::string("notes\0.svg", 10));
  put("levine/levine.json", figures.dump());
  run("sphere");
  for (const std::string& file : kept) EXPECT_EQ(contents(file), "of the user") << file;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "levine/hull-group-1.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "levine/sphere-group-1.svg"));
}

TEST_F(CommandTest, ExperimentThatCannotWriteTellsItsFiguresAndLeavesTheEarlierOnes) {
  std::vector<std::string> levine{"experiment", "levine", "--cases", "2",
                                  "--only",     "hull",   "--out",   "levine"};
  ASSERT_EQ(cigsim(levine).exit_code, 0);
  const std::vector<std::string> before = files();
  const std::string figures = contents("levine/levine.json");
  levine.insert(levine.end(), {"--seed", "9"});
  const Outcome full = cigsim(levine, {.file_size = 8000, .memory = {}});
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_NE(full.err.find("levine/levine.json"), std::string::npos) << full.err;
  EXPECT_NE(full.out.find("Published, and ours"), std::string::npos) << full.out;
  EXPECT_EQ(files(), before);
  EXPECT_EQ(contents("levine/levine.json"), figures);

  for (const char* plot : {"levine/hull-group-1.svg", "levine/hull-histograms.svg"}) {
    std::filesystem::remove(folder_ / plot);
    std::filesystem::create_directory(folder_ / plot);
  }
  const Outcome blocked = cigsim(levine);
  EXPECT_EQ(blocked.exit_code, 2);
  EXPECT_NE(blocked.err.find("levine.json: has the figures, but levine/hull-group-1.svg"),
            std::string::npos)
      << blocked.err;
  EXPECT_NE(blocked.out.find("levine/hull-group-2.svg written"), std::string::npos) << blocked.out;
  EXPECT_EQ(Json::parse(contents("levine/levine.json"))["seed"], 9);
}

TEST_F(CommandTest, ExperimentDoesNotOverwriteWhatItDidNotWrite) {
  std::filesystem::create_directory(folder_ / "levine");
  const std::vector<std::string> levine{"experiment", "levine", "--cases", "1",
                                        "--only",     "hull",   "--out",   "levine"};
  const std::string deep(1000000, '[');
  for (const std::string& others :
       {std::string(R"({"plots": ["notes.svg"]})"), std::string(R"(["notes.svg"])"),
        std::string("no JSON"), std::string(R"({"experiment": "growth", "plots": []})"),
        R"({"experiment": "levine", "plots": )" + deep}) {
    put("levine/levine.json", others);
    put("levine/notes.svg", "of the user");
    const Outcome outcome = cigsim(levine);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("levine/levine.json was not written by an earlier run"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(contents("levine/levine.json"), others);
    EXPECT_EQ(contents("levine/notes.svg"), "of the user");
  }
  std::filesystem::remove(folder_ / "levine/levine.json");
  ASSERT_EQ(::mkfifo((folder_ / "levine/levine.json").c_str(), 0600), 0);
  EXPECT_EQ(cigsim(levine).exit_code, 2);
  std::filesystem::remove(folder_ / "levine/levine.json");
  std::filesystem::create_directory(folder_ / "levine/levine.json");
  EXPECT_EQ(cigsim(levine).exit_code, 2);
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
