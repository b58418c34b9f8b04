// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

class StabilityCommand : public CommandTest {
 protected:
  Json json(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "stability");
    arguments.push_back("--json");
    const Outcome outcome = cigsim(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(StabilityCommand, TellsWhereFormatsAreWrong) {
  const Outcome outcome =
      cigsim({"stability", "--decision", "side", "--decision", "hull", "--trials", "10"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words : {"decision        float", "certified", "nasa1968", "% near ",
                            "in any format, 0 of", "Claims: all", "held"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
  EXPECT_TRUE(files().empty());
}

TEST_F(StabilityCommand, WritesHeatMapsAndFigures) {
  const Outcome outcome =
      cigsim({"stability", "--decision", "side", "--format", "float", "--format", "double",
              "--axis", "near", "--trials", "5", "--out", "found"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"found", "found/stability-near.svg",
                                               "found/stability.json", "found/stability.svg"}));
  EXPECT_NE(contents("found/stability-near.svg").find("<svg"), std::string::npos);
}

// Planted: a float that flips a side, words that are too narrow; doubles do neither.
TEST_F(StabilityCommand, FirstFailuresCanBeRepeated) {
  const Json found = json({"--decision", "side", "--format", "float", "--format", "double",
                           "--format", "machine:16,12,8,4", "--trials", "10", "--seed", "7"});
  EXPECT_EQ(found["seed"], 7);
  EXPECT_TRUE(found["scene"].is_null());
  const Json& side = found["decisions"][0];
  EXPECT_GT(side["formats"][0]["wrong"], 0);
  EXPECT_EQ(side["formats"][1]["wrong"], 0);
  EXPECT_EQ(side["formats"][1]["broken"], 0);
  EXPECT_GT(side["formats"][2]["wrong"], 0);
  for (const Json& axis : side["axes"]) {
    EXPECT_EQ(axis["values"].size(), axis["formats"][0]["wrong"].size());
    if (axis["axis"] != "near") continue;
    const Json& first = axis["formats"][0]["first_failure"];
    EXPECT_EQ(first["instance"]["planes"].size(), 1u);
    EXPECT_EQ(first["instance"]["view"]["eye"].size(), 3u);
    EXPECT_TRUE(axis["formats"][1]["first_failure"].is_null());
  }
}

TEST_F(StabilityCommand, FiguresAreTheSameForASeed) {
  const std::vector<std::string> arguments{"stability", "--trials",  "1",
                                           "--part",    "decisions", "--json"};
  const Outcome one = cigsim(arguments), two = cigsim(arguments);
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out, two.out);
}

TEST_F(StabilityCommand, FurtherPartsCanBeAskedForAlone) {
  const Outcome outcome =
      cigsim({"stability", "--part", "accumulation", "--part", "published", "--out", "parts"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"parts", "parts/accumulation.svg",
                                               "parts/published.svg", "parts/stability.json"}));
  const Json found = Json::parse(contents("parts/stability.json"));
  EXPECT_FALSE(found.contains("decisions"));
  EXPECT_GT(found["accumulation"]["rows"].size(), 0u);
}

// Planted: files with names that the command could write and the earlier run did not.
TEST_F(StabilityCommand, AFolderNeverMixesTwoRuns) {
  const Outcome many = cigsim({"stability", "--trials", "1", "--part", "decisions", "--part",
                               "envelope", "--part", "published", "--out", "found"});
  ASSERT_EQ(many.exit_code, 0) << many.err;
  EXPECT_GT(files().size(), 10u);
  for (const char* of_the_user : {"found/flicker.svg", "found/mine.svg"}) put(of_the_user, "{}");
  put("found/tradeoff.json", "{}");
  const std::vector<std::string> before = files();
  expect_unusable({"stability", "--decision", "colour", "--out", "found"}, "choose from");
  EXPECT_EQ(files(), before);
  const Outcome one = cigsim({"stability", "--decision", "side", "--axis", "near", "--format",
                              "float", "--trials", "1", "--out", "found"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"found", "found/flicker.svg", "found/mine.svg",
                                               "found/stability-near.svg", "found/stability.json",
                                               "found/stability.svg", "found/tradeoff.json"}));
  EXPECT_FALSE(Json::parse(contents("found/stability.json")).contains("flicker"));
}

TEST_F(StabilityCommand, TellsOfTheFormatsThatWereAskedForAlone) {
  const Json found = json({"--format", "float", "--trials", "1"});
  EXPECT_FALSE(found.contains("published"));
  EXPECT_EQ(found["left_out"], Json({"published of float: it has formats of its own"}));
  ASSERT_EQ(found["envelope"]["formats"].size(), 1u);
  EXPECT_EQ(found["envelope"]["formats"][0]["format"], "float");
  for (const char* part : {"accumulation", "flicker"}) {
    EXPECT_GT(found[part]["rows"].size(), 0u);
    for (const Json& row : found[part]["rows"]) EXPECT_EQ(row["format"], "float");
  }
  for (const char* format : {"exact", "machine:24,22,16,12"})
    EXPECT_FALSE(json({"--format", format, "--trials", "1"}).contains("envelope")) << format;
  const Json named = json({"--part", "envelope", "--format", "unlimited", "--format", "float",
                           "--format", "machine:24,22,16,12"});
  ASSERT_EQ(named["envelope"]["formats"].size(), 2u);
  EXPECT_EQ(named["envelope"]["formats"][0]["format"], "unlimited");
  EXPECT_EQ(named["left_out"].size(), 1u);
  const Outcome hither =
      cigsim({"stability", "--decision", "hither", "--format", "double", "--trials", "1"});
  EXPECT_NE(hither.out.find("hither          -\n"), std::string::npos) << hither.out;
}

TEST_F(StabilityCommand, DoesNotOverwriteItsScene) {
  std::filesystem::create_directory(folder_ / "found");
  const std::string scene = R"({"cigsim": 1, "objects": [{"vertices": [[0, 0, 0], [1, 0, 0],
                                [0, 1, 0], [0, 0, 1]], "faces": [[0, 2, 1], [0, 1, 3],
                                [0, 3, 2], [1, 2, 3]]}]})";
  put("found/stability.json", scene);
  const Outcome outcome =
      cigsim({"stability", "found/stability.json", "--decision", "side", "--format", "float",
              "--axis", "near", "--trials", "1", "--out", "found"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(contents("found/stability.json"), scene);
}

TEST_F(StabilityCommand, AsksASceneAboutItsOwnThings) {
  const Json found =
      json({CIGSIM_SOURCE_DIR "/scenes/airfield.json", "--decision", "side", "--decision", "edge",
            "--format", "certified", "--format", "float", "--trials", "3"});
  EXPECT_NE(found["scene"].get<std::string>().find("airfield.json"), std::string::npos);
  for (const Json& decision : found["decisions"]) {
    EXPECT_EQ(decision["formats"][0]["wrong"], 0);
    EXPECT_GT(decision["formats"][0]["posed"], 0);
  }
}

TEST_F(StabilityCommand, RefusesWhatItCannotUse) {
  expect_unusable({"stability", "--decision", "colour"}, "choose from convexity");
  expect_unusable({"stability", "--part", "colour"}, "choose from decisions");
  expect_unusable({"stability", "--axis", "length"}, "choose from scale");
  expect_unusable({"stability", "--format", "flaot"}, "--format");
  expect_unusable({"stability", "--decision", "side", "--axis", "fov"}, "side is not driven along");
  expect_unusable({"stability", "--decision", "side", "--part", "flicker"}, "choose decisions");
  expect_unusable({"stability", "--envelope", "--part", "flicker"}, "add --part envelope");
  expect_unusable({"stability", "--part", "envelope", "--format", "machine:24,22,16,12"},
                  "add --envelope to search");
  expect_unusable({"stability", "--envelope", "--format", "exact"}, "no limits");
  expect_unusable({"stability", "--part", "accumulation", "--format", "certified"},
                  "exact on every line");
  expect_unusable({"stability", "--part", "published", "--format", "float"}, "formats of its own");
  expect_unusable({"stability", "--format", "machine:24,22,15,12"}, "even");
  expect_unusable({"stability", "--format", "machine:99,22,16,12"}, "--format");
  expect_unusable({"stability", "--trials", "0"}, "--trials");
  expect_unusable({"stability", "--part", "flicker", "--trials", "5"}, "--trials");
  expect_unusable({"stability", "--seed", "-1"}, "--seed");
  expect_unusable({"stability", "missing.json"}, "missing.json");
  put("file", "");
  expect_unusable({"stability", "--trials", "1", "--out", "file"}, "--out");
  put("empty.json", R"({"cigsim": 1, "objects": []})");
  expect_unusable({"stability", "empty.json"}, "empty.json");
  put("far.json", R"({"cigsim": 1, "objects": [{"vertices": [[0, 0, 0], [1e200, 0, 0], [0, 1, 0]],
                      "faces": [[0, 1, 2]]}]})");
  expect_unusable({"stability", "far.json"}, "larger unit");
}

}  // namespace
}  // namespace cigsim
