// SPDX-License-Identifier: MIT
// cigsim tradeoff as a process of its own.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

// Two boxes, one behind the other, some millions of units from the origin.
std::string far_boxes() {
  std::string obj;
  int first = 1;
  for (const double x : {20'000'000.0, 20'000'003.0}) {
    obj += "o box\n";
    for (int corner = 0; corner < 8; ++corner)
      obj += fmt::format("v {} {} {}\n", x + (corner & 1), 20'000'000.0 + 2 * (corner >> 1 & 1),
                         2 * (corner >> 2));
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& f : kFaces)
      obj += fmt::format("f {} {} {} {}\n", first + f[0], first + f[1], first + f[2], first + f[3]);
    first += 8;
  }
  return obj;
}

const Json& point(const Json& result, const std::string& name) {
  for (const Json& one : result.at("points"))
    if (one.at("name") == name) return one;
  throw std::runtime_error("no point " + name);
}

void strip_host(Json& json) {
  if (json.is_object()) json.erase("host");
  for (Json& part : json)
    if (part.is_structured()) strip_host(part);
}

// The planted bad case: a scene where float takes wrong decisions and doubles do not.
TEST_F(CommandTest, TradeoffFindsASceneThatFloatCannotShow) {
  put("far.obj", far_boxes());
  const Outcome outcome = cigsim({"tradeoff", "far.obj", "--eye", "19999995.5,20000000.25,1.75",
                                  "--look-at", "20000001,20000001,1", "--raster", "64x48",
                                  "--levels", "functional", "--rounds", "1", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  EXPECT_GT(point(result, "float")["error"]["wrong"], 30);
  EXPECT_GT(point(result, "float")["error"]["worst_distance"], 1);
  EXPECT_EQ(point(result, "double")["error"]["wrong"], 0);
  EXPECT_EQ(point(result, "certified")["error"]["wrong"], 0);
  EXPECT_EQ(point(result, "exact")["error"]["wrong"], 0);
}

TEST_F(CommandTest, TradeoffFindsAMachineWordTooNarrow) {
  const Outcome outcome = cigsim({"tradeoff", "--path", "builtin", "--frames", "2", "--raster",
                                  "96x64", "--levels", "functional", "--rounds", "1", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  const auto wrong = [&](const char* name) {
    return point(result, name)["error"]["wrong"].get<int>();
  };
  EXPECT_GT(wrong("coordinate_bits 16"), 10 * (wrong("machine") + 1));
  EXPECT_LT(wrong("machine"), 96 * 64 * 2 / 50);
  // Twice the elements show the same at their middles but near edges.
  EXPECT_GT(wrong("raster 1/4"), wrong("raster 1/2"));
  EXPECT_EQ(wrong("retrieval off"), wrong("double"));
  EXPECT_EQ(wrong("coherence off"), wrong("double"));
}

// Planted: a machine that holds two items of a scene with many.
TEST_F(CommandTest, TradeoffTellsThatAMachineIsOverloaded) {
  Json machine = Json::parse(cigsim({"machines", "asupt1975", "--json"}).out);
  machine["figures"]["object_capacity"]["value"] = 2;
  put("tiny.json", machine.dump());
  std::vector<std::string> arguments{"tradeoff", "--raster",         "40x30",
                                     "--levels", "functional,timed", "--rounds",
                                     "1",        "--machine",        "tiny.json"};
  const Outcome table = cigsim(arguments);
  ASSERT_EQ(table.exit_code, 0) << table.err;
  EXPECT_NE(table.out.find("† overloaded in 1 of 1 frames: "), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("†  number    machine"), std::string::npos) << table.out;
  arguments.push_back("--json");
  const Json result = Json::parse(cigsim(arguments).out);
  EXPECT_TRUE(point(result, "double")["overload"].is_null());
  for (const char* name : {"machine", "timed"}) {
    EXPECT_EQ(point(result, name)["overload"]["overloaded"], 1) << name;
    EXPECT_GT(point(result, name)["overload"]["dropped_items"], 0) << name;
    EXPECT_GT(point(result, name)["error"]["wrong"], 0) << name;
  }
}

TEST_F(CommandTest, TradeoffIsTheSameForTheSameSeedButForTheHost) {
  const std::vector<std::string> arguments{
      "tradeoff", "--raster", "40x30",  "--levels", "functional,timed",
      "--rounds", "2",        "--seed", "7",        "--json"};
  Json first = Json::parse(cigsim(arguments).out), again = Json::parse(cigsim(arguments).out);
  EXPECT_GT(point(first, "double")["host"]["frame_ms"]["median"], 0);
  strip_host(first);
  strip_host(again);
  EXPECT_EQ(first, again);
  EXPECT_EQ(first["seed"], 7);
}

TEST_F(CommandTest, TradeoffLevelsAgreeWithTheRefereeInCycles) {
  const Outcome outcome = cigsim({"tradeoff", "--path", "builtin", "--frames", "2", "--raster",
                                  "40x30", "--levels", "timed,clocked", "--rounds", "1", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  EXPECT_EQ(result["referee"], "clocked");
  int compared = 0;
  for (const Json& one : result["points"]) {
    if (one["cycles"].is_null()) continue;
    ++compared;
    EXPECT_EQ(one["cycles"]["error"], 0) << one["name"];
    EXPECT_EQ(one["cycles"]["delays"].size(), 2u);
  }
  EXPECT_EQ(compared, 7);  // timed, clocked, and one of five stages clocked
}

TEST_F(CommandTest, TradeoffPrintsATableAndWritesItsFiles) {
  const Outcome outcome = cigsim({"tradeoff", "--raster", "40x30", "--levels", "functional",
                                  "--rounds", "1", "--out", "new/folder"});
  if (outcome.err.find("gnuplot-nox") != std::string::npos) GTEST_SKIP() << "no gnuplot";
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\n* "), std::string::npos) << "the Pareto front";
  EXPECT_EQ(Json::parse(contents("new/folder/tradeoff.json"))["experiment"], "tradeoff");
  const std::string svg = contents("new/folder/tradeoff.svg");
  EXPECT_NE(svg.find("Pareto front"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

// A drawing of an earlier run does not stay beside figures that are not its own.
TEST_F(CommandTest, TradeoffThatCannotDrawKeepsItsFiguresAlone) {
  std::vector<std::string> words{"tradeoff", "--raster", "40x30", "--levels", "functional",
                                 "--rounds", "1",        "--out", "out"};
  const Outcome earlier = cigsim(words);
  ASSERT_EQ(earlier.exit_code, 0) << earlier.err;
  ASSERT_TRUE(std::filesystem::exists(folder_ / "out/tradeoff.svg"));
  put("out/notes.json", "{}");
  std::filesystem::create_directory(folder_ / "bin");
  put("bin/gnuplot", "#!/bin/sh\nexit 1\n");
  std::filesystem::permissions(folder_ / "bin/gnuplot", std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", ((folder_ / "bin").string() + ":" + path).c_str(), 1);
  words.insert(words.end(), {"--seed", "7"});
  const Outcome outcome = cigsim(words);
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("out/tradeoff.json: has the figures"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("was not drawn"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("certified"), std::string::npos) << "the table";
  EXPECT_EQ(Json::parse(contents("out/tradeoff.json"))["seed"], 7);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/tradeoff.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/notes.json"));
}

TEST_F(CommandTest, TradeoffGivesUpWhatTakesTooLong) {
  const Outcome outcome = cigsim({"tradeoff", "--raster", "40x30", "--levels", "functional",
                                  "--rounds", "1", "--limit", "0.001"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("given up: "), std::string::npos) << outcome.out;
}

TEST_F(CommandTest, TradeoffRefusesWhatItCannotMeasure) {
  expect_unusable({"tradeoff", "--levels", "functional,quick"}, "--levels: 'quick'");
  expect_unusable({"tradeoff", "--levels", ""}, "--levels: ''");
  expect_unusable({"tradeoff", "--rounds", "0"}, "--rounds");
  expect_unusable({"tradeoff", "--limit", "0"}, "--limit");
  expect_unusable({"tradeoff", "--levels", "functional", "--raster", "4097x100"},
                  "machine words take part in every trade-off");
  expect_unusable({"tradeoff", "none.obj"}, "none.obj");
  expect_unusable({"tradeoff", "--raster", "4096x4096", "--frames", "100"}, "smaller raster");
}

}  // namespace
}  // namespace cigsim
