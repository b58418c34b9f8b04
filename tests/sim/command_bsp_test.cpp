// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

const std::string kScenes = std::string(CIGSIM_SOURCE_DIR) + "/scenes/";

TEST_F(CommandTest, BspOfTheOverlappingPolygons) {
  const Outcome outcome = cigsim({"bsp", kScenes + "fuchs-overlap.json", "--rule", "1", "--eye",
                                  "-3,-16,20", "--json", "-o", "tree.json", "--tree", "tree.svg"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_EQ(r["polygons"], 3);
  EXPECT_EQ(r["fragments"], 5);
  EXPECT_EQ(r["leaves"], r["nodes"].get<int>() + 1);
  ASSERT_EQ(r["priorities"].size(), 5u);
  EXPECT_EQ(r["priorities"][0]["priority"], 5);
  const Json file = Json::parse(contents("tree.json"));
  EXPECT_EQ(file["tree"]["polygons"].size(), 5u);
  EXPECT_EQ(file["tree"]["nodes"].size(), 5u);
  EXPECT_NE(contents("tree.svg").find(">B1<"), std::string::npos) << "a part of a split polygon";
}

TEST_F(CommandTest, BspTableIsForReading) {
  const Outcome outcome = cigsim({"bsp", kScenes + "fuchs-blocks.json", "--rule", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words : {"fragments", " 100  ", "depth", "leaves"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
  EXPECT_TRUE(files().empty());
}

TEST_F(CommandTest, BspRefusesWhatItCannotUse) {
  const std::string scene = kScenes + "fuchs-overlap.json";
  expect_unusable({"bsp"}, "SCENE");
  expect_unusable({"bsp", "none.json"}, "no such file");
  expect_unusable({"bsp", scene, "--rule", "3"}, "choose from first, 1, 2, cost");
  expect_unusable({"bsp", scene, "--weight", "2"}, "--weight belongs to --rule 2");
  expect_unusable({"bsp", scene, "--rule", "2", "--weight", "x"}, "--weight");
  expect_unusable({"bsp", scene, "--candidates", "0"}, "--candidates");
  expect_unusable({"bsp", scene, "--eye", "1,2"}, "--eye");
  expect_unusable({"bsp", scene, "--tree", "tree.png"}, "--tree");
  expect_unusable({"bsp", scene, "-o", "tree.obj"}, "-o");
  EXPECT_TRUE(files().empty());
}

TEST_F(CommandTest, BspRefusesAPreparedDatabase) {
  ASSERT_EQ(cigsim({"prepare", kScenes + "fuchs-overlap.json", "-o", "db.json"}).exit_code, 0);
  expect_unusable({"bsp", "db.json"}, "is prepared");
}

}  // namespace
}  // namespace cigsim
