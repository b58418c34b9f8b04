// SPDX-License-Identifier: MIT
// cigsim compare-algorithms, sorts and clip as a person runs them.
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;
using SurveyCommandTest = CommandTest;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n";

TEST_F(SurveyCommandTest, CompareAlgorithmsOnTheAirfield) {
  const Outcome outcome =
      cigsim({"compare-algorithms", "--raster", "128x96", "--repeat", "2", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_GT(r["faces"], 100);
  ASSERT_EQ(r["algorithms"].size(), 7u);
  for (const Json& row : r["algorithms"]) {
    EXPECT_EQ(row["differs"], 0) << row["name"];
    EXPECT_GT(row["work"]["writes"], 0);
  }
  EXPECT_EQ(r["algorithms"][6]["name"], "z-buffer");
  EXPECT_DOUBLE_EQ(r["algorithms"][6]["relative"], 54);
}

// Sutherland, Sproull and Schumacker's relative costs for 100, 2,500 and 60,000 faces.
TEST_F(SurveyCommandTest, CompareAlgorithmsTellsTheSurveysOrdersOfMagnitude) {
  put("a.obj", kTriangle);
  const Outcome outcome = cigsim({"compare-algorithms", "a.obj", "--raster", "16x16"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto row = [&](const std::string& name) {
    const std::size_t at = outcome.out.find("\n" + name) + 1;
    return outcome.out.substr(at, outcome.out.find('\n', at) - at);
  };
  EXPECT_NE(row("Schumacker").find("|    30    179    1215"), std::string::npos);
  EXPECT_NE(row("Newell").find("|     1     10     507"), std::string::npos);
  EXPECT_NE(row("Warnock").find("|    11     64     307"), std::string::npos);
  EXPECT_NE(row("z-buffer").find("|    54     54      54"), std::string::npos);
  EXPECT_NE(row("Watkins").find("|     -      -       -"), std::string::npos);
  EXPECT_NE(outcome.out.find("orders of magnitude only"), std::string::npos);
}

TEST_F(SurveyCommandTest, AViewOfNothing) {
  put("a.obj", kTriangle);
  for (const char* command : {"compare-algorithms", "sorts", "clip"}) {
    const Outcome outcome =
        cigsim({command, "a.obj", "--raster", "16x16", "--eye", "0,-5,0", "--attitude", "180,0,0"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_FALSE(outcome.out.empty());
  }
}

// The scene has no right order, as its table says, and the machine's picture is wrong.
TEST_F(SurveyCommandTest, CompareAlgorithmsEndsWithOneWhereTheMachineIsWrong) {
  const std::string scene = std::string(CIGSIM_SOURCE_DIR) + "/scenes/stump-not-listable.json";
  const Outcome outcome = cigsim({"compare-algorithms", scene, "--raster", "200x150", "--json"});
  const Json r = Json::parse(outcome.out);
  std::uint64_t differs = 0;
  for (const Json& row : r["algorithms"]) differs += row["differs"].get<std::uint64_t>();
  EXPECT_EQ(outcome.exit_code, differs == 0 ? 0 : 1);
  EXPECT_EQ(r["algorithms"][2]["name"], "Schumacker");
  EXPECT_EQ(r["algorithms"][2]["differs"], 0);  // he uses the machine's own order
}

TEST_F(SurveyCommandTest, SortsOfTheAirfieldAndTheExample) {
  const Outcome outcome = cigsim({"sorts", "--raster", "160x120", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json r = Json::parse(outcome.out);
  ASSERT_EQ(r["lists"].size(), 4u);
  const Json& carried = r["lists"][1]["sorts"];
  const Json& afresh = r["lists"][2]["sorts"];
  EXPECT_EQ(carried[0]["sort"], "bubble");
  EXPECT_LT(carried[0]["exchanges"], afresh[0]["exchanges"]);
  EXPECT_LT(afresh[1]["comparisons"], carried[1]["comparisons"]);  // quicksort likes disorder
  const Outcome example = cigsim({"sorts", "--example"});
  ASSERT_EQ(example.exit_code, 0) << example.err;
  EXPECT_NE(example.out.find("154  426  275  503  897  908  512  509  677  703"),
            std::string::npos);
  EXPECT_NE(example.out.find("503  703  908  509  512  426  154  275  677  897"),
            std::string::npos);
}

TEST_F(SurveyCommandTest, ClipOfTheAirfield) {
  const Outcome outcome = cigsim({"clip", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_GT(r["items"]["tested"], 0);
  EXPECT_EQ(r["view_plane"], 1);
}

TEST_F(SurveyCommandTest, WrongUse) {
  expect_unusable({"clip", "--view-plane", "0"}, "--view-plane");
  expect_unusable({"clip", "--view-plane", "x"}, "--view-plane");
  expect_unusable({"compare-algorithms", "--repeat", "0"}, "--repeat");
  expect_unusable({"compare-algorithms", "missing.json"}, "missing.json");
  expect_unusable({"sorts", "--example", "--json"}, "--example");
  expect_unusable({"sorts", "--raster", "0x5"}, "--raster");
}

}  // namespace
}  // namespace cigsim
