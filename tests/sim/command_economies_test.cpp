// SPDX-License-Identifier: MIT
// The economies of the command: --retrieval, --coherence, and the experiments that measure them.
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

// Without what depends on the host: "host", and times and memory by their units.
Json strip(const Json& value) {
  if (!value.is_structured()) return value;
  if (value.is_array()) {
    Json out = Json::array();
    for (const Json& v : value) out.push_back(strip(v));
    return out;
  }
  Json out = Json::object();
  for (const auto& [key, v] : value.items()) {
    if (key == "host" || key.ends_with("_ms") || key.ends_with("_s") || key.ends_with("_mib"))
      continue;
    out[key] = strip(v);
  }
  return out;
}

class EconomyCommand : public CommandTest {
 protected:
  Json run(std::vector<std::string> arguments) {
    std::vector<std::string> all{"run", "--path", "builtin", "--frames", "4", "--raster", "64x64"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = cigsim(all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(contents("out/stats.json"));
  }
  std::string pictures() const {
    std::string all;
    for (const char* n : {"0", "1", "2", "3"})
      all += contents(std::string("out/frame-000") + n + ".png") +
             contents(std::string("out/ids-000") + n + ".pgm");
    return all;
  }
};

TEST_F(EconomyCommand, SwitchedOffGivesTheSamePictures) {
  const Json on = run({});
  const std::string want = pictures();
  EXPECT_EQ(on["options"]["retrieval"], true);
  EXPECT_EQ(on["options"]["coherence"], true);
  const Json anew = run({"--coherence", "off"});
  EXPECT_EQ(pictures(), want);
  EXPECT_EQ(anew["options"]["coherence"], false);
  const Json everything = run({"--retrieval", "off"});
  EXPECT_EQ(pictures(), want);
  EXPECT_EQ(everything["options"]["retrieval"], false);
  for (std::size_t f = 0; f < 4; ++f) {
    const Json &kept = on["frames"][f], &fresh = anew["frames"][f];
    EXPECT_EQ(fresh["reused_groups"], 0);
    EXPECT_GT(fresh["ordered_groups"], 0);
    EXPECT_EQ(kept["ordered_groups"].get<int>() + kept["reused_groups"].get<int>(),
              fresh["ordered_groups"].get<int>());
    EXPECT_LE(kept["tested_planes"], fresh["tested_planes"]);
    EXPECT_GT(everything["frames"][f]["active_items"], kept["active_items"]);
  }
}

TEST_F(EconomyCommand, AreNotTheMachinesToChooseOnItsOwnWords) {
  const Json words = run({"--number", "machine"});
  EXPECT_TRUE(words["options"]["retrieval"].is_null());
  EXPECT_TRUE(words["options"]["coherence"].is_null());
  EXPECT_GT(words["frames"][0]["ordered_groups"], 0);
  std::filesystem::remove_all(folder_ / "out");
  expect_unusable({"run", "--number", "machine", "--retrieval", "off"}, "--retrieval");
  expect_unusable({"run", "--level", "timed", "--coherence", "on"}, "--coherence");
  expect_unusable({"run", "--retrieval", "perhaps"}, "choose from on, off");
}

TEST_F(EconomyCommand, ExperimentEconomiesWritesTheSameFiguresTwice) {
  const std::vector<std::string> words{"experiment", "economies", "--quick", "--scene",
                                       CIGSIM_SOURCE_DIR "/scenes/levine-towers.json"};
  std::vector<std::string> as_json = words, files_too = words;
  as_json.push_back("--json");
  files_too.insert(files_too.end(), {"--out", "e"});
  const Outcome first = cigsim(as_json), table = cigsim(files_too);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  ASSERT_EQ(table.exit_code, 0) << table.err;
  for (const char* part : {"retrieval", "coherence", "levels of detail", "SO matrix", "smoothing"})
    EXPECT_NE(table.out.find(part), std::string::npos) << part;
  EXPECT_EQ(files(), (std::vector<std::string>{"e", "e/economies.json", "e/economies.svg"}));
  const Json a = Json::parse(first.out);
  Json b = Json::parse(contents("e/economies.json"));
  EXPECT_EQ(b["plots"], Json({"economies.svg"}));
  b.erase("plots");
  EXPECT_EQ(strip(a), strip(b));
  EXPECT_EQ(a["holds"], true);
  EXPECT_EQ(a["scenes"].size(), 1u);
  EXPECT_TRUE(a["scenes"][0]["so"]["why_not"].is_null());
}

TEST_F(EconomyCommand, SaysWhyATableMadeByHandHasNoMatrix) {
  const std::vector<std::string> words{"experiment", "economies", "--quick", "--scene",
                                       CIGSIM_SOURCE_DIR "/scenes/stump-reassigned.json"};
  std::vector<std::string> as_json = words;
  as_json.push_back("--json");
  const Json so = Json::parse(cigsim(as_json).out)["scenes"][0]["so"];
  EXPECT_EQ(so["groups_left_out"], so["frames"]);
  const std::string why = so["why_not"];
  EXPECT_NE(why.find("made by hand"), std::string::npos) << why;
  EXPECT_NE(cigsim(words).out.find("SO matrix: none; " + why), std::string::npos);
}

TEST_F(EconomyCommand, ExperimentGrowthWritesTheSameFiguresTwice) {
  const Outcome first = cigsim({"experiment", "growth", "--quick", "--json"}),
                table = cigsim({"experiment", "growth", "--quick", "--out", "g"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  ASSERT_EQ(table.exit_code, 0) << table.err;
  for (const char* part : {"planes of a group", "expected", "Floors", "growth.svg written"})
    EXPECT_NE(table.out.find(part), std::string::npos) << part;
  const Json a = Json::parse(first.out);
  Json b = Json::parse(contents("g/growth.json"));
  EXPECT_EQ(b["plots"], Json({"growth.svg"}));
  b.erase("plots");
  EXPECT_EQ(strip(a), strip(b));
  EXPECT_EQ(a["good"], true);
}

// A folder tells of one run of an experiment, and other files in it stay. Figures stay where they
// cannot be drawn.
TEST_F(EconomyCommand, AFolderTellsOfOneExperiment) {
  for (const std::string name : {"economies", "growth"}) {
    std::filesystem::create_directories(folder_ / name);
    put(name + "/" + name + ".svg", "old");
    put(name + "/notes.txt", "mine");
    put(name + "/" + (name == "growth" ? "economies" : "growth") + ".json", "another's");
    std::vector<std::string> words{"experiment", name, "--quick", "--out", name};
    if (name == "economies")
      words.insert(words.end(), {"--scene", CIGSIM_SOURCE_DIR "/scenes/levine-cubes-4.json"});
    const Outcome outcome = cigsim(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(contents(name + "/" + name + ".json"))["experiment"], name);
    EXPECT_EQ(contents(name + "/" + name + ".svg").find("old"), std::string::npos);
    EXPECT_EQ(contents(name + "/notes.txt"), "mine");
    EXPECT_EQ(contents(name + "/" + (name == "growth" ? "economies" : "growth") + ".json"),
              "another's");

    std::filesystem::remove(folder_ / name / (name + ".svg"));
    std::filesystem::create_directories(folder_ / name / (name + ".svg"));
    words.insert(words.end(), {"--seed", "7"});
    EXPECT_EQ(cigsim(words).exit_code, 2);
    EXPECT_EQ(Json::parse(contents(name + "/" + name + ".json"))["seed"], 7);
    EXPECT_EQ(contents(name + "/notes.txt"), "mine");
  }
}

TEST_F(EconomyCommand, QuickRoundsAreThoseAskedFor) {
  const Outcome outcome =
      cigsim({"experiment", "economies", "--quick", "--frames", "1", "--rounds", "3", "--json",
              "--scene", CIGSIM_SOURCE_DIR "/scenes/levine-cubes-4.json"});
  EXPECT_EQ(Json::parse(outcome.out)["rounds"], 3);
}

TEST_F(EconomyCommand, GrowthOfTheFewestObjectsHolds) {
  const Outcome outcome = cigsim({"experiment", "growth", "--objects", "1000", "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(Json::parse(outcome.out)["good"], true);
}

TEST_F(EconomyCommand, ExperimentsRefuseWhatTheyCannotUse) {
  expect_unusable({"experiment", "economies", "--scene", "none.json"}, "none.json");
  expect_unusable({"experiment", "economies", "--rounds", "0"}, "--rounds");
  expect_unusable({"experiment", "growth", "--objects", "999"}, "--objects");
  expect_unusable({"experiment", "growth", "--quick", "--objects", "5000"}, "--quick");
  put("file", "");
  expect_unusable({"experiment", "growth", "--quick", "--out", "file"}, "--out");
}

}  // namespace
}  // namespace cigsim
