// SPDX-License-Identifier: MIT
// The experiment of economies: what it finds on a small scene, and that it finds an economy that
// changes the picture.
#include "sim/experiments/economies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "sim/experiments/economies_json.hpp"
#include "sim/scene.hpp"

namespace cigsim {
namespace {

EconomyOptions quick() {
  EconomyOptions options;
  options.frames = 6;
  options.raster = {64, 64};
  options.rounds = 2;
  return options;
}

const EconomyResult& result(const SceneEconomies& economies, const std::string& name) {
  return *std::find_if(economies.results.begin(), economies.results.end(),
                       [&](const EconomyResult& r) { return r.economy.name == name; });
}

std::uint64_t saved(const EconomyResult& r, const std::string& what) {
  for (const EconomyCount& c : r.counts)
    if (c.what == what) return c.without - c.with;
  return 0;
}

class EconomiesOfACity : public testing::Test {
 protected:
  const EconomyOptions options_ = quick();
  const Database database_ = prepare(generate_environment("city", {120, 1}));
  const EconomyScene scene_{"city", &database_, slow_flight(database_, options_.frames)};
};

TEST_F(EconomiesOfACity, KeepThePictureAndSaveWork) {
  const SceneEconomies economies = run_economies(scene_, options_);
  EXPECT_TRUE(economies.holds());
  std::vector<std::string> names;
  for (const EconomyResult& r : economies.results) {
    names.push_back(r.economy.name);
    EXPECT_TRUE(r.holds()) << r.economy.name;
    EXPECT_GT(r.with.frame_ms.median, 0) << r.economy.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"stages", "clocked stages", "retrieval", "coherence",
                                             "no ground"}));
  EXPECT_GT(saved(result(economies, "coherence"), "planes tested"), 0u);
  EXPECT_GT(saved(result(economies, "coherence"), "groups ordered"), 0u);
  EXPECT_EQ(result(economies, "clocked stages").with.delays.size(), 2u);
  EXPECT_GT(result(economies, "no ground").differing, 0u);
  EXPECT_GT(economies.so.full_cycles, economies.so.update.cycles);
  EXPECT_GT(economies.so.first.cycles, 0u);
  EXPECT_GT(economies.so.pairs, 0u);
  EXPECT_EQ(economies.so.wrong_rows, 0u);
}

// Retrieval that leaves out too much, stages that draw something else.
TEST_F(EconomiesOfACity, OneThatChangesThePictureIsFound) {
  LeanDatabases lean;
  for (Economy economy : economies_of(scene_, options_, lean)) {
    if (!economy.same_pictures) continue;
    const Database other = prepare(generate_environment("city", {119, 1}));
    economy.database_with = &other;
    const EconomyResult r = run_economy(economy, scene_, options_);
    EXPECT_GT(r.differing, 0u) << economy.name;
    EXPECT_FALSE(r.holds()) << economy.name;
    SceneEconomies all{scene_, {r}, {}};
    EXPECT_FALSE(all.holds());
    EconomyReport report{all, {}};
    EXPECT_FALSE(economies_json({report}, options_)["holds"].get<bool>());
    EXPECT_NE(economies_text(report).find("DIFFERS"), std::string::npos);
  }
}

TEST_F(EconomiesOfACity, OneThatChangesTheCyclesIsFound) {
  EconomyResult r;
  r.economy.same_cycles = true;
  r.with.delays = {100, 200};
  r.without.delays = {100, 200};
  EXPECT_TRUE(r.holds());
  r.without.delays.back() = 201;
  EXPECT_FALSE(r.holds());
}

TEST(Economies, OfAttributesAreThoseThatTheSceneHas) {
  const EconomyOptions options = quick();
  LeanDatabases lean;
  const Database airfield = load_scene({}, {}).database;
  const EconomyScene scene{"airfield", &airfield, slow_flight(airfield, 2)};
  std::vector<std::string> names;
  for (const Economy& economy : economies_of(scene, options, lean)) names.push_back(economy.name);
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  EXPECT_EQ(has("no moving models"), airfield.systems.size() > 1);
  EXPECT_EQ(has("no ground"), !airfield.ground.faces.empty());
  const Database towers =
      prepare(read_environment(CIGSIM_SOURCE_DIR "/scenes/levine-towers.json").environment);
  const EconomyScene of_towers{"towers", &towers, slow_flight(towers, 2)};
  names.clear();
  for (const Economy& economy : economies_of(of_towers, options, lean))
    names.push_back(economy.name);
  EXPECT_TRUE(has("levels of detail"));
}

}  // namespace
}  // namespace cigsim
