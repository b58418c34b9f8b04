// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

const std::string kBlock = std::string(CIGSIM_SOURCE_DIR) + "/scenes/pfister-block.cards";
const std::string kNotch = std::string(CIGSIM_SOURCE_DIR) + "/scenes/pfister-notch.cards";

class CommandCards : public CommandTest {};

TEST_F(CommandCards, DrawsThePicturesOfTheDeck) {
  const Outcome run = cigsim({"cards", kBlock, "--out", "block"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("10 vertices, 7 faces, 15 edges, 0 of them concave"), std::string::npos);
  EXPECT_EQ(files(),
            (std::vector<std::string>{"block", "block/frame-0000.svg", "block/frame-0001.svg"}));
  EXPECT_NE(contents("block/frame-0000.svg").find("</svg>"), std::string::npos);
}

TEST_F(CommandCards, KeysOfAScript) {
  put("turn.keys", "3   # turn\n0\n9\n\n5 5\n6 11\n");
  const Outcome run = cigsim({"cards", kNotch, "--keys", "turn.keys", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  const auto& frames = json["frames"];
  ASSERT_EQ(frames.size(), 2u + 7);
  EXPECT_EQ(frames[2]["theta"], 22);
  EXPECT_EQ(frames[6]["theta"], 30);
  EXPECT_EQ(frames[7]["theta"], 30);
  EXPECT_EQ(frames[4]["r"], 12.25);
  EXPECT_EQ(frames[7]["r"], 13);
  EXPECT_EQ(frames[8]["r"], 13);
  EXPECT_EQ(json["structures"][0]["concave_edges"], 1);
}

TEST_F(CommandCards, AsPublishedDistancesMoveOnce) {
  put("far.keys", "9\n0\n0\n11\n");
  const Outcome run = cigsim({"cards", kBlock, "--keys", "far.keys", "--as-published", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto frames = nlohmann::json::parse(run.out)["frames"];
  EXPECT_EQ(frames[4]["r"], 12.25);
  EXPECT_EQ(frames[5]["r"], 12);
}

TEST_F(CommandCards, UnusableInput) {
  put("bad.keys", "3\n99\n");
  put("one.keys", "1\n");
  put("open.cards",
      "'VERTEX' X=0,Y=0,Z=0,NEDGES=0,TAG=1;\n'VERTEX' X=1,TAG=2;'VERTEX' Y=1,TAG=3;\n"
      "'FACE' LABEL=1 NVERT=3; 1 2 3 'END STRUCTURE DATA'\n"
      "'VIEW DATA' R=9,D=3,THETA=0,PHI=0,DR=0,DD=0,DTHETA=0,DPHI=0; 'PLOT' DELAY=1;\n");
  expect_unusable({"cards", kBlock, "--keys", "bad.keys"}, "bad.keys:2: \"99\" is no whole number");
  expect_unusable({"cards", kBlock, "--keys", "one.keys"}, "one.keys:1: key 1 only waits");
  expect_unusable({"cards", "open.cards"}, "open.cards:3: edge 1-2 has one face only");
  expect_unusable({"cards", "none.cards"}, "none.cards");
  expect_unusable({"cards", kBlock, "--live"}, "--live needs a terminal");
  expect_unusable({"cards", kBlock, "--out", "bad.keys"}, "bad.keys");
}

}  // namespace
}  // namespace cigsim
