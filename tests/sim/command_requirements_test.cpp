// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

bool used(const Json& requirements, const std::string& attribute) {
  for (const Json& row : requirements["attributes"])
    if (row["name"] == attribute) return row["used"];
  ADD_FAILURE() << "no attribute " << attribute;
  return false;
}

TEST_F(CommandTest, RequirementsOfTheAirfield) {
  const Outcome outcome = cigsim({"requirements", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_GT(r["database"]["objects"], 100);
  EXPECT_GT(r["database"]["models"], 1);
  EXPECT_LE(r["database"]["largest_group_members"], 64);
  EXPECT_GT(r["view"]["worst_line_crossings"], 0);
  EXPECT_TRUE(used(r, "moving models"));
  EXPECT_TRUE(used(r, "ground"));
  EXPECT_TRUE(used(r, "sun shading"));
  EXPECT_FALSE(used(r, "lights"));
  EXPECT_TRUE(files().empty()) << "requirements writes no file";
}

TEST_F(CommandTest, RequirementsOfOneTriangle) {
  put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  const Outcome outcome = cigsim({"requirements", "a.obj", "--raster", "16x16", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_EQ(r["database"]["objects"], 1);
  EXPECT_EQ(r["database"]["faces"], 1);
  EXPECT_EQ(r["database"]["edges"], 3);
  EXPECT_EQ(r["database"]["planes"], 0);
  EXPECT_EQ(r["view"]["front_faces"], 1);
  EXPECT_EQ(r["view"]["worst_line_crossings"], 2);
  EXPECT_FALSE(used(r, "moving models"));
  EXPECT_FALSE(used(r, "ground"));
  EXPECT_TRUE(used(r, "two-sided faces"));
}

TEST_F(CommandTest, RequirementsOverAPathAreTheWorst) {
  const auto worst = [&](const std::vector<std::string>& words) {
    const Outcome outcome = cigsim(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out)["view"];
  };
  put("a.csv", "x,y,z,heading,pitch,roll\n0,-500,40,0,-4,0\n0,-500,40,180,60,0\n");
  const Json both = worst({"requirements", "--path", "a.csv", "--json"});
  const Json first = worst({"requirements", "--path", "a.csv", "--frames", "1", "--json"});
  EXPECT_EQ(both["frames"], 2);
  EXPECT_EQ(both["crossings"], first["crossings"]) << "the second row looks at the sky";
  EXPECT_GT(first["crossings"], 0);
}

TEST_F(CommandTest, RequirementsTableIsForReading) {
  const Outcome outcome = cigsim({"requirements"});
  ASSERT_EQ(outcome.exit_code, 0);
  for (const char* word : {"objects", "largest_group_members", "worst_line_crossings", "ground"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace cigsim
