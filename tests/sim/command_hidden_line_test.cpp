// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

const std::string kScenes = std::string(CIGSIM_SOURCE_DIR) + "/scenes/";

class CommandHiddenLine : public CommandTest {};

TEST_F(CommandHiddenLine, DrawsTheCityWithLevinesCounters) {
  const Outcome run =
      cigsim({"hidden-line", kScenes + "levine-city.json", "-o", "city.svg", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["solids"], 16);
  EXPECT_EQ(json["unresolved_pairs"], 0);
  const auto& frame = json["frames"][0];
  EXPECT_EQ(frame["front_faces"], 48);
  EXPECT_EQ(frame["edges_displayed"], 144);
  EXPECT_GT(frame["actual_intersections"], 0);
  EXPECT_NE(contents("city.svg").find("<line"), std::string::npos);
}

TEST_F(CommandHiddenLine, HiddenLinesDashedAndWireFrames) {
  const std::vector<std::string> plain{"hidden-line", kScenes + "levine-cubes-4.json", "-o",
                                       "a.svg"};
  EXPECT_EQ(cigsim(plain).exit_code, 0);
  EXPECT_EQ(contents("a.svg").find("dasharray"), std::string::npos);
  std::vector<std::string> dashed = plain;
  dashed.insert(dashed.end(), {"--hidden", "dashed"});
  EXPECT_EQ(cigsim(dashed).exit_code, 0);
  EXPECT_NE(contents("a.svg").find("dasharray"), std::string::npos);
  std::vector<std::string> wires = plain;
  wires.insert(wires.end(), {"--wire", "1,2,3,4", "--json"});
  const Outcome run = cigsim(wires);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["frames"][0]["edges_displayed"], 48);
}

TEST_F(CommandHiddenLine, FramesOfAPathAreNumbered) {
  const Outcome run = cigsim({"hidden-line", "--path", "builtin", "--frames", "3", "-o", "f.svg"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"f-0000.svg", "f-0001.svg", "f-0002.svg"}));
}

TEST_F(CommandHiddenLine, DecksOfPfister) {
  const Outcome run =
      cigsim({"hidden-line", kScenes + "pfister-notch.cards", "-o", "n.svg", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["figures"], 10);
}

TEST_F(CommandHiddenLine, UnusableInput) {
  expect_unusable({"hidden-line", kScenes + "levine-city.json", "-o", "a.png"}, "-o");
  expect_unusable({"hidden-line", "none.obj", "-o", "a.svg"}, "none.obj");
  expect_unusable({"hidden-line", kScenes + "levine-cubes-4.json", "-o", "a.svg", "--wire", "5"},
                  "there is no object 5");
  expect_unusable({"hidden-line", kScenes + "levine-cubes-4.json", "-o", "a.svg", "--hidden", "x"},
                  "--hidden");
  ASSERT_EQ(cigsim({"prepare", kScenes + "levine-cubes-4.json", "-o", "p.json"}).exit_code, 0);
  expect_unusable({"hidden-line", "p.json", "-o", "a.svg"}, "is a prepared database");
  expect_unusable({"hidden-line", kScenes + "levine-cubes-4.json", "-o", "no/where.svg"},
                  "no/where.svg");
}

}  // namespace
}  // namespace cigsim
