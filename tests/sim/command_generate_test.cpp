// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

TEST_F(CommandTest, EveryKindThatHelpListsCanBeMadeAndRendered) {
  std::istringstream help(cigsim({"generate", "--help"}).out);
  std::string line;
  while (std::getline(help, line) && line != "Kinds:") {
  }
  int kinds = 0;
  for (; std::getline(help, line) && !line.empty(); ++kinds) {
    const std::string kind = line.substr(2, line.find(' ', 2) - 2);
    SCOPED_TRACE(kind);
    const Outcome made = cigsim({"generate", kind, "--objects", "12", "-o", "s.json", "--json"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Json figures = Json::parse(made.out);
    EXPECT_EQ(figures["kind"], kind);
    EXPECT_GT(figures["objects"], 0);
    EXPECT_EQ(cigsim({"run", "s.json", "--raster", "32x32"}).exit_code, 0);
  }
  EXPECT_GE(kinds, 3);
}

TEST_F(CommandTest, TheSeedDecidesTheScene) {
  for (const auto& [file, seed] : {std::pair{"a.json", "7"}, {"b.json", "7"}, {"c.json", "8"}})
    ASSERT_EQ(
        cigsim({"generate", "random", "--objects", "9", "--seed", seed, "-o", file}).exit_code, 0);
  EXPECT_EQ(contents("a.json"), contents("b.json"));
  EXPECT_NE(contents("a.json"), contents("c.json"));
}

TEST_F(CommandTest, GenerateRefusesWhatItDoesNotKnow) {
  expect_unusable({"generate", "forest", "-o", "a.json"}, "KIND: 'forest' is not known");
  expect_unusable({"generate", "city", "-o", "a.stl"}, "must end in .json or .cbor or .obj");
  expect_unusable({"generate", "city", "-o", "a.json", "--objects", "0"}, "--objects");
  expect_unusable({"generate", "city", "-o", "a.json", "--seed", "-1"}, "--seed");
  expect_unusable({"generate", "city", "-o", "absent/a.json"}, "absent/a.json");
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace cigsim
