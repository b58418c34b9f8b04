// SPDX-License-Identifier: MIT
// cigsim run --detail on the scene that ships for it.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

const std::string kTowers = CIGSIM_SOURCE_DIR "/scenes/levine-towers.json";

class DetailCommand : public CommandTest {
 protected:
  Json run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run", kTowers, "--raster", "160x120", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = cigsim(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(DetailCommand, ScaledThresholdsTradeFacesForDetail) {
  std::uint64_t last = 1000000;
  for (const char* scale : {"most", "0.25", "1", "2", "1e9"}) {
    const Json stats = run({"--detail", scale});
    const Json& frame = stats["frames"][0];
    EXPECT_LT(frame["faces"], last) << scale;
    last = frame["faces"];
    if (std::string(scale) == "1") {
      EXPECT_EQ(frame["detail"]["descriptions"].size(), 3u);
    }
    if (std::string(scale) == "1e9") {
      EXPECT_EQ(frame["detail"], (Json{{"choices", 16}, {"descriptions", {16}}}));
    }
    EXPECT_EQ(frame["faults"], 0);
  }
}

TEST_F(DetailCommand, MostIsTheSceneWithoutLevelsToTheBit) {
  const auto strip = [](Json& list, auto& self) -> Json {
    Json flat = Json::array();
    for (Json& entry : list) {
      if (!entry.contains("descriptions")) {
        flat.push_back(entry);
        continue;
      }
      for (Json& description : entry["descriptions"]) {
        const bool last = &description == &entry["descriptions"].back();
        for (Json& object : self(description["objects"], self)) {
          if (!last) object["faces"] = Json::array();
          flat.push_back(object);
        }
      }
    }
    return flat;
  };
  std::ifstream in(kTowers);
  Json scene = Json::parse(in);
  scene["objects"] = strip(scene["objects"], strip);
  put("plain.json", scene.dump());
  for (const char* level : {"functional", "timed"}) {
    const Json most = run({"--detail", "most", "--level", level, "--number", "machine"});
    const std::string picture = contents("out/frame-0000.png"), ids = contents("out/ids-0000.pgm");
    const Outcome outcome = cigsim({"run", "plain.json", "--raster", "160x120", "--level", level,
                                    "--number", "machine", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(contents("out/frame-0000.png"), picture) << level;
    EXPECT_EQ(contents("out/ids-0000.pgm"), ids) << level;
    EXPECT_EQ(Json::parse(outcome.out)["frames"][0]["cycles"], most["frames"][0]["cycles"]);
  }
}

TEST_F(DetailCommand, APreparedDatabaseKeepsItsLevels) {
  for (const char* file : {"towers.json", "towers.cbor"}) {
    ASSERT_EQ(cigsim({"prepare", kTowers, "-o", file}).exit_code, 0);
    const Json from_scene = run({});
    const std::string picture = contents("out/frame-0000.png");
    const Outcome outcome = cigsim({"run", file, "--raster", "160x120", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(contents("out/frame-0000.png"), picture);
    EXPECT_EQ(Json::parse(outcome.out)["frames"][0]["detail"], from_scene["frames"][0]["detail"]);
    EXPECT_EQ(from_scene["preparation"]["choices"], 32);
  }
}

TEST_F(DetailCommand, ScalesThatAreNoneAreRefused) {
  for (const char* scale : {"0", "-1", "inf", "nan", "least", "", "1x"})
    expect_unusable({"run", "--detail", scale}, "neither a number above 0 nor the word most");
}

TEST_F(DetailCommand, RequirementsCountChoices) {
  const Outcome outcome = cigsim({"requirements", kTowers, "--raster", "160x120", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json figures = Json::parse(outcome.out);
  EXPECT_EQ(figures["database"]["choices"], 32);
  const auto& attributes = figures["attributes"];
  const auto used = [](const Json& a) { return a["name"] == "levels of detail" && a["used"]; };
  EXPECT_EQ(std::count_if(attributes.begin(), attributes.end(), used), 1);
}

}  // namespace
}  // namespace cigsim
