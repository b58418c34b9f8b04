// SPDX-License-Identifier: MIT
// cigsim compare and cigsim replay. A comparison that cannot fail proves nothing: faults are
// planted in every stage, and must be found, reported, and found again by the replay.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

// Libraries that ship are taken, whatever the scene's size: nothing is built.
class CompareTest : public CommandTest {
 protected:
  CompareTest() {
    setenv("CIGSIM_RTL_CACHE", (folder_ / "cache").c_str(), 1);
    path_ = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
  }
  ~CompareTest() override { setenv("PATH", path_.c_str(), 1); }

  static std::vector<std::string> small(std::vector<std::string> more) {
    std::vector<std::string> words{"compare",
                                   "--stage",
                                   "priority_processor,edge_orderer,"
                                   "priority_resolver",
                                   "--raster",
                                   "64x48",
                                   "--vectors",
                                   "3000"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  std::string path_;
};

TEST_F(CompareTest, AllStagesAgreeOnTheAirfieldAndOnRandomVectors) {
  const Outcome outcome = cigsim(small({"--path", "builtin", "--frames", "3", "--json"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["mismatches"], 0);
  EXPECT_EQ(json["frames"], 6) << "three of the path, a random one a policy";
  EXPECT_GE(json["pictures"], 5);
  EXPECT_GT(json["words"], 1000);
  EXPECT_GT(json["cycles"], 3 * 266'667);
  EXPECT_GE(json["so_matrix"]["vectors"], 3000);
  EXPECT_GT(json["so_matrix"]["pairs"], 50'000);
  EXPECT_FALSE(json.contains("mismatch"));
  EXPECT_FALSE(json.contains("replay"));
}

TEST_F(CompareTest, TheSummaryEndsWithTheResultAndACommandForWaves) {
  const Outcome outcome = cigsim(small({}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("0 mismatches\n"), std::string::npos);
  EXPECT_NE(outcome.out.find(" kHz\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("cigsim run --machine asupt1975 --raster 64x48 --level "
                             "priority_processor=rtl,edge_orderer=rtl,priority_resolver=rtl "
                             "--wave rtl.vcd"),
            std::string::npos);
}

TEST_F(CompareTest, TheCommandForWavesNamesTheSceneAsAShellTakesIt) {
  const auto scene = folder_ / "four cubes.json";
  std::filesystem::copy_file(CIGSIM_SOURCE_DIR "/scenes/levine-cubes-4.json", scene);
  const Outcome outcome = cigsim({"compare", scene.string(), "--stage", "priority_resolver",
                                  "--raster", "64x48", "--vectors", "0"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("cigsim run '" + scene.string() + "' --machine"), std::string::npos);
}

// Whole flights, and 204 random scenes with waits on every link, under all overload policies.
TEST_F(CompareTest, TheApproachAndRandomScenesAreTheSameAtEveryLevel) {
  setenv("PATH", path_.c_str(), 1);
  const Outcome outcome =
      cigsim({"compare", "--stage", "priority_processor,edge_orderer,priority_resolver", "--raster",
              "160x120", "--path", "builtin", "--frames", "12", "--vectors", "204000", "--seed",
              "7", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["mismatches"], 0);
  EXPECT_EQ(json["frames"], 12 + 204);
  EXPECT_EQ(json["pictures"], 12 + 204);
}

struct Fault {
  const char *stuck, *stage, *field;
};
class PlantedFault : public CompareTest, public testing::WithParamInterface<Fault> {};

TEST_P(PlantedFault, IsFoundReportedAndReplayed) {
  const Fault& fault = GetParam();
  const Outcome outcome = cigsim(small({"--stuck", fault.stuck, "--json"}));
  ASSERT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["mismatches"], 1);
  const auto& mismatch = json["mismatch"];
  EXPECT_EQ(mismatch["stage"], fault.stage);
  EXPECT_EQ(mismatch["field"], fault.field);
  EXPECT_NE(mismatch["expected"], mismatch["got"]);
  EXPECT_FALSE(mismatch["inputs"].empty());

  // Again, alone: one frame is enough, and what is seen is the same.
  const std::string replay = json["replay"];
  const auto file = nlohmann::json::parse(contents(replay));
  EXPECT_EQ(file["frames_of_machine"]["frames"].size(), 1u);
  const Outcome again = cigsim({"replay", replay, "--wave", "again.vcd", "--json"});
  EXPECT_EQ(again.exit_code, 1) << again.err;
  const auto seen = nlohmann::json::parse(again.out)["mismatch"];
  EXPECT_EQ(seen["field"], fault.field);
  EXPECT_EQ(seen, file["frames_of_machine"]["mismatch"]);

  // The wave has both models, around the cycle; the view opens there.
  const std::string wave = contents("again.vcd");
  EXPECT_NE(wave.find(std::string(" ") + fault.stage + "_twin "), std::string::npos);
  const std::string view = contents("again.gtkw");
  EXPECT_NE(view.find(std::string("cigsim.") + fault.stage + "_twin."), std::string::npos);
  const long cycle = seen["cycle"].get<long>(), unit_in_cycle = 1250;
  EXPECT_NE(view.find(" " + std::to_string(cycle * unit_in_cycle) + " -1 "), std::string::npos)
      << view.substr(0, 300);
}

INSTANTIATE_TEST_SUITE_P(
    , PlantedFault,
    testing::Values(
        Fault{"priority_processor.items.item:0=1", "priority_processor", "items_word.item"},
        Fault{"priority_processor.items.valid=0", "priority_processor", "items_valid"},
        Fault{"edge_orderer.crossings.element:2=0", "edge_orderer", "crossings_word.element"},
        Fault{"edge_orderer.crossings.end=0", "edge_orderer", "crossings_word.end"},
        Fault{"priority_resolver.spans.first:3=1", "priority_resolver", "spans_word.first"},
        Fault{"priority_resolver.spans.last=1", "priority_resolver", "spans_word.last"}),
    [](const testing::TestParamInfo<Fault>& info) {
      std::string name = info.param.stuck;
      for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
      return name;
    });

TEST_F(CompareTest, AFaultOfTheSoMatrixIsFoundAndReplayed) {
  const std::vector<std::string> engine{"compare",  "--stage", "priority_processor",
                                        "--raster", "16x16",   "--vectors",
                                        "3000",     "--stuck", "so_engine.answer_hides_o:5=0"};
  const Outcome outcome = cigsim(engine);
  ASSERT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("answer_hides_o"), std::string::npos) << outcome.out;
  const Outcome again = cigsim({"replay", "out/mismatch.json"});
  EXPECT_EQ(again.exit_code, 1) << again.err;
  EXPECT_NE(again.out.find("answer_hides_o"), std::string::npos) << again.out;
}

TEST_F(CompareTest, AMendedFaultIsNoMismatchAnyMore) {
  cigsim(small({"--stuck", "priority_resolver.spans.valid=1"}));
  auto file = nlohmann::json::parse(contents("out/mismatch.json"));
  file["frames_of_machine"].erase("stuck");
  put("mended.json", file.dump());
  const Outcome outcome = cigsim({"replay", "mended.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("no mismatch any more"), std::string::npos) << outcome.out;
}

// A file that was edited must not pass because something else was run, or nothing.
TEST_F(CompareTest, AReplayFileThatWasEditedIsRefused) {
  using Json = nlohmann::json;
  cigsim({"compare", "--stage", "priority_resolver", "--raster", "16x16", "--vectors", "0",
          "--stuck", "priority_resolver.spans.valid=1"});
  const Json whole = Json::parse(contents("out/mismatch.json"))["frames_of_machine"];
  const auto refuse = [&](const char* place, const Json& value, const char* message) {
    SCOPED_TRACE(place);
    Json edited = whole;
    edited[Json::json_pointer(place)] = value;
    put("edited.json", Json{{"cigsim-replay", 1}, {"frames_of_machine", edited}}.dump());
    expect_unusable({"replay", "edited.json"}, message);
  };
  refuse("/rtl", Json::array(), "stage");
  refuse("/rtl/0/stage", "edge_orderer", "stage");
  refuse("/rtl/0/stage", "video_processor", "stage");
  refuse("/rtl/0/module", "../so_engine", "does not hold its frames");
  refuse("/rtl/0/parameters/0/name", "Lines", "does not hold its frames");
  refuse("/rtl/0/parameters/0/value", 64, "does not hold its frames");
  refuse("/rtl/0/parameters/0/value", 1 << 30, "too large");
  refuse("/rtl/0/parameters/0/value", -1, "value is -1");
  refuse("/rtl/1", whole["rtl"][0], "twice");
  refuse("/frames", Json::array(), "no frames");
  refuse("/frames/0/database", 1, "a database that is not there");
  refuse("/frames/0/fov", 180, "fov");
  refuse("/eye_reach", -1, "eye_reach");
  refuse("/seed", 0, "seed is 0");
  refuse("/stuck/field", "colour", "not known");
  refuse("/stuck/bit", 1, "has bits 0 to 0");
  refuse("/mismatch/cycle", std::uint64_t{1} << 63, "cycle is");
}

TEST_F(CompareTest, AReplayFileOfTheSoMatrixThatWasEditedIsRefused) {
  using Json = nlohmann::json;
  cigsim({"compare", "--stage", "priority_processor", "--raster", "16x16", "--vectors", "100",
          "--so-size", "16x16", "--stuck", "so_engine.start_ready_o=0"});
  const Json whole = Json::parse(contents("out/mismatch.json"))["so_matrix"];
  const auto refuse = [&](const char* place, const Json& value, const char* message) {
    SCOPED_TRACE(place);
    Json edited = whole;
    edited[Json::json_pointer(place)] = value;
    put("edited.json", Json{{"cigsim-replay", 1}, {"so_matrix", edited}}.dump());
    expect_unusable({"replay", "edited.json"}, message);
  };
  refuse("/objects", 257, "objects is 257");
  refuse("/objects", 15, "a row for each object");
  refuse("/planes", 0, "planes is 0");
  refuse("/eye", std::string(64, 'f'), "eye has more than 16 bits");
  refuse("/rows/0/tells", "0", "64 hexadecimal digits");
  refuse("/stuck/output", "answer_o", "no output named answer_o");
  refuse("/stuck/bit", 1, "has bits 0 to 0");
  put("whole.json", Json{{"cigsim-replay", 1}, {"so_matrix", whole}}.dump());
  expect_unusable({"replay", "whole.json", "--wave", "w.vcd"}, "--wave: is for replays of frames");
}

TEST_F(CompareTest, AMismatchIsToldWhereNoReplayFileCanBeWritten) {
  put("file", "");
  const Outcome outcome =
      cigsim({"compare", "--stage", "priority_resolver", "--raster", "16x16", "--vectors", "0",
              "--stuck", "priority_resolver.spans.valid=1", "--out", "file"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("Mismatch  priority_resolver"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Replay"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("cigsim: no replay file: "), std::string::npos) << outcome.err;
}

TEST_F(CompareTest, ASizeThatDoesNotShipIsBuiltOnceAndElseTheNextLargerStandsIn) {
  const std::vector<std::string> words{
      "compare",   CIGSIM_SOURCE_DIR "/scenes/levine-cubes-24.json",
      "--stage",   "priority_resolver",
      "--raster",  "32x24",
      "--vectors", "0"};
  const Outcome without = cigsim(words);
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_NE(without.err.find("verilator is not installed"), std::string::npos) << without.err;
  EXPECT_NE(without.err.find("takes its place"), std::string::npos) << without.err;

  setenv("PATH", path_.c_str(), 1);
  if (std::system("command -v verilator >/dev/null") != 0) GTEST_SKIP() << "no Verilator here";
  const Outcome first = cigsim(words);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.err.find("building priority_resolver-Faces=256"), std::string::npos) << first.err;
  const Outcome second = cigsim(words);
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(second.err, "");
}

TEST_F(CompareTest, WhereTheCacheCannotBeWrittenAShippedSizeTakesItsPlace) {
  setenv("PATH", path_.c_str(), 1);
  if (std::system("command -v verilator >/dev/null") != 0) GTEST_SKIP() << "no Verilator here";
  // A folder that there is, and in which nothing can be made, for root neither.
  setenv("CIGSIM_RTL_CACHE", "/proc/self", 1);
  const Outcome outcome =
      cigsim({"compare", CIGSIM_SOURCE_DIR "/scenes/levine-cubes-24.json", "--stage",
              "priority_resolver", "--raster", "32x24", "--vectors", "0"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("cannot be built"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("takes its place"), std::string::npos) << outcome.err;
}

TEST_F(CompareTest, WhatCannotBeComparedIsRefused) {
  expect_unusable({"compare"}, "--stage");
  expect_unusable({"compare", "--stage", "resolver"}, "priority_resolver");
  expect_unusable({"compare", "--stage", "video_processor"}, "has no RTL");
  expect_unusable({"compare", "--stage", "priority_resolver", "--stuck", "spans"}, "--stuck");
  expect_unusable(
      {"compare", "--stage", "priority_resolver", "--stuck", "priority_resolver.spans.colour:1=1"},
      "choose from");
  expect_unusable(
      {"compare", "--stage", "priority_resolver", "--stuck", "priority_resolver.spans.last:1=1"},
      "has bits 0 to 0");
  expect_unusable(
      {"compare", "--stage", "priority_resolver", "--stuck", "edge_orderer.crossings.face:1=1"},
      "add it to --stage");
  expect_unusable({"compare", "--stage", "priority_resolver", "--seed", "0"}, "--seed");
  for (const char* vectors : {"0", "100"})
    expect_unusable({"compare", "--stage", *vectors == '0' ? "priority_processor" : "edge_orderer",
                     "--vectors", vectors, "--stuck", "so_engine.answer_hides_o:5=0"},
                    "so_engine is not compared");
  expect_unusable({"compare", "--stage", "priority_processor", "--so-size", "16x16", "--stuck",
                   "so_engine.answer_hides_o:16=0"},
                  "has bits 0 to 15");
  for (const char* size : {"64", "x", "64x", "1x64", "64x257", "64x64x64"})
    expect_unusable({"compare", "--stage", "priority_processor", "--so-size", size}, "--so-size");
  expect_unusable({"replay", "nowhere.json"}, "nowhere.json: cannot be read");
  put("scene.json", R"({"cigsim": 1})");
  expect_unusable({"replay", "scene.json"}, "is no replay file");
  put("part.json", R"({"cigsim-replay": 1, "frames_of_machine": {"name": "x"}})");
  expect_unusable({"replay", "part.json"}, "is no replay file");
}

}  // namespace
}  // namespace cigsim
