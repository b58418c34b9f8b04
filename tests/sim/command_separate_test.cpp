// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

std::string deck(int number) {
  return CIGSIM_SOURCE_DIR "/scenes/stump-case-" + std::to_string(number) + ".deck";
}

// Two unit cubes from z = 0 to 1, the second begins at `at`.
std::string two_cubes(const std::string& at, const std::string& to) {
  std::string text;
  for (const auto& [low, high] : {std::pair<std::string, std::string>{"0.00", "1.00"}, {at, to}}) {
    int n = 0;
    for (const char* z : {"0.00", "1.00"})
      for (const auto& [x, y] :
           {std::pair{low, "0.00"}, {high, "0.00"}, {high, "1.00"}, {low, "1.00"}}) {
        const auto field = [](const std::string& v) { return std::string(8 - v.size(), ' ') + v; };
        text += "V     " + std::to_string(++n) + field(x) + field(y) + field(z) + "\n";
      }
    text +=
        "F     1  2  3  4\nF     5  8  7  6\nF     1  5  6  2\n"
        "F     2  6  7  3\nF     3  7  8  4\nF     4  8  5  1\n";
  }
  return text + "E\n";
}

TEST_F(CommandTest, SeparateAsPublishedPrintsFig10) {
  const Outcome outcome = cigsim({"separate", deck(1), "--as-published"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "NUMBER OF SEPARATION PLANES REQUIRED =   1\n\nFOR PLANE NUMBER  1\n"
            "THE UNIT NORMAL IS:  1.0  0.0  0.0\nAND THE DIRECTED DISTANCE IS: 10.0\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              2         1\n"
            "NORMAL TERMINATION\n");
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(files().empty());
}

TEST_F(CommandTest, SeparateFindsTheFewestAndProvesThem) {
  for (int k = 1; k <= 3; ++k) {
    const Outcome outcome = cigsim({"separate", deck(k), "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json r = Json::parse(outcome.out);
    const std::size_t planes = k == 3 ? 4 : static_cast<std::size_t>(k);
    EXPECT_EQ(r["planes"].size(), planes);
    EXPECT_EQ(r["published_planes"], planes);
    EXPECT_EQ(r["least"]["proved"], true);
    EXPECT_EQ(r["least"]["over_all_planes"], true);
    EXPECT_EQ(r["listable"], true);
  }
}

TEST_F(CommandTest, SeparateWritesASceneThatRunsAndIsProved) {
  for (const char* rule : {"--json", "--as-published"}) {
    ASSERT_EQ(cigsim({"separate", deck(2), rule, "-o", "case.json"}).exit_code, 0);
    EXPECT_EQ(files(), (std::vector<std::string>{"case.json"}));
    const Json scene = Json::parse(contents("case.json"));
    EXPECT_EQ(scene["separation"].size(), 2u);
    EXPECT_EQ(cigsim({"listable", "case.json"}).exit_code, 0);
    EXPECT_EQ(cigsim({"run", "case.json", "--raster", "32x32", "--out", "out"}).exit_code, 0);
    std::filesystem::remove_all(folder_ / "out");
  }
}

TEST_F(CommandTest, SeparateSaysWhenObjectsReachIntoEachOther) {
  put("a.deck", two_cubes("0.50", "1.50"));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"separate", "a.deck", "-o", "a.json"},
        {"separate", "a.deck", "--as-published", "-o", "a.json"}}) {
    const Outcome outcome = cigsim(words);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "SEPARATION PLANES COULD NOT BE FOUND.\n");
  }
  const Outcome outcome = cigsim({"separate", "a.deck", "--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(Json::parse(outcome.out)["found"], false);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.deck"}));
}

TEST_F(CommandTest, SeparateTakesOtherScenesToo) {
  ASSERT_EQ(cigsim({"generate", "city", "--objects", "20", "-o", "city.json"}).exit_code, 0);
  const Outcome outcome = cigsim({"separate", "city.json", "--json", "-o", "table.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["listable"], true);
  EXPECT_EQ(cigsim({"listable", "table.json"}).exit_code, 0);
}

TEST_F(CommandTest, SeparateRefusesWhatItCannotUse) {
  expect_unusable({"separate", "none.deck"}, "none.deck:");
  put("bad.deck", "V     1    0.00    0.00    0.00\nX\nE\n");
  expect_unusable({"separate", "bad.deck"}, "bad.deck:2: unknown card type");
  put("empty.deck", "E\n");
  expect_unusable({"separate", "empty.deck"}, "empty.deck:1: holds no object");
  put("a.deck", two_cubes("2.00", "3.00"));
  expect_unusable({"separate", "a.deck", "-o", "a.obj"}, "-o");
  expect_unusable({"separate"}, "DECK");
  expect_unusable({"separate", CIGSIM_SOURCE_DIR "/scenes/airfield.json"}, "moves");
  expect_unusable({"separate", "a.deck", "-o", "nowhere/a.json"}, "nowhere/a.json");
}

}  // namespace
}  // namespace cigsim
