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
  EXPECT_NE(outcome.out.find("magnitude only"), std::string::npos);
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

// No plane parts the first two objects, and the machine shows the far one in front.
constexpr const char* kNoOrder = R"({"cigsim": 1, "name": "no plane between two",
 "view": {"eye": [0, -20, 0], "look_at": [0, 0, 0], "fov": 45},
 "objects": [
  {"name": "far", "vertices": [[-2,2,-2],[2,2,-2],[-2,3,-2],[-2,2,2]],
   "faces": [[0,2,1],[0,1,3],[0,3,2],[1,2,3]]},
  {"name": "near", "vertices": [[-1,-3,-1],[1,-3,-1],[-1,-2,-1],[-1,-3,1]],
   "faces": [[0,2,1],[0,1,3],[0,3,2],[1,2,3]]},
  {"name": "aside", "vertices": [[5,2,-2],[7,2,-2],[5,3,-2],[5,2,2]],
   "faces": [[0,2,1],[0,1,3],[0,3,2],[1,2,3]]}],
 "separation": [{"normal": [1, 0, 0], "distance": 4, "pairs": [[3, 1], [3, 2]]}]})";

TEST_F(SurveyCommandTest, CompareAlgorithmsEndsWithOneWhereTheMachineIsWrong) {
  put("a.json", kNoOrder);
  const Outcome outcome = cigsim({"compare-algorithms", "a.json", "--raster", "64x64", "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_EQ(r["listability_faults"], 1);
  for (const Json& row : r["algorithms"])  // Schumacker uses the machine's own order
    EXPECT_EQ(row["differs"] == 0, row["name"] == "Schumacker") << row["name"];
  const Outcome table = cigsim({"compare-algorithms", "a.json", "--raster", "64x64"});
  EXPECT_EQ(table.exit_code, 1);
  EXPECT_NE(table.out.find("no right order"), std::string::npos);
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
