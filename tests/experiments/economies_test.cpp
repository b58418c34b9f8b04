// SPDX-License-Identifier: MIT
// The experiment of economies: what it finds on a small scene, and that it finds an economy that
// changes the picture.
#include "sim/experiments/economies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/database/prepare.hpp"
#include "models/database/separation_pairs.hpp"
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
  const EconomySide& clocked = result(economies, "clocked stages").with;
  ASSERT_EQ(clocked.delays.size(), options_.rounds);
  EXPECT_EQ(clocked.digests.size(), options_.rounds);
  EXPECT_EQ(clocked.delays.front().size(), 2u);
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
    EXPECT_EQ(r.differing > 0, economy.setting_with.levels.functional()) << economy.name;
    EXPECT_GT(r.wrong_rounds(), 0u) << economy.name;
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
  r.with.delays = {{100, 200}, {100, 200}};
  r.without.delays = r.with.delays;
  EXPECT_TRUE(r.holds());
  for (EconomySide* side : {&r.with, &r.without})
    for (std::vector<Cycle>& round : side->delays)
      for (Cycle& delay : round) {
        ++delay;
        EXPECT_FALSE(r.holds());
        --delay;
      }
  EXPECT_TRUE(r.holds());
}

// Any round's pictures tell, those of an economy that trades pictures among themselves.
TEST_F(EconomiesOfACity, OneThatChangesThePicturesOfARoundIsFound) {
  for (const bool same : {true, false}) {
    EconomyResult r;
    r.economy.same_pictures = same;
    r.without.digests = {7, 7, 7};
    r.with.digests = same ? r.without.digests : std::vector<std::uint64_t>{8, 8, 8};
    EXPECT_EQ(r.wrong_rounds(), 0u);
    for (EconomySide* side : {&r.with, &r.without})
      for (std::uint64_t& digest : side->digests) {
        ++digest;
        EXPECT_FALSE(r.holds()) << same;
        --digest;
      }
  }
}

// A city without one of its objects, in the first of two frames; the last looks at the sky.
TEST_F(EconomiesOfACity, OneThatChangesOnlyAnEarlierFrameIsFound) {
  const Database other = prepare(generate_environment("city", {119, 1}));
  Viewpoint up{database_.view.eye, database_.view.fov};
  up.eye.pitch = 90;
  EconomyScene scene = scene_;
  scene.views = {scene_.views.front(), {up, 1}};
  LeanDatabases lean;
  for (Economy economy : economies_of(scene, options_, lean)) {
    if (!economy.same_pictures) continue;
    economy.database_with = &other;
    EXPECT_FALSE(run_economy(economy, scene, options_).holds()) << economy.name;
    EconomyScene sky = scene;
    sky.views.front() = sky.views.back();
    EXPECT_TRUE(run_economy(economy, sky, options_).holds()) << economy.name;
  }
}

// Whatever the table says, a matrix of planes holds it when each plane resolves all that it parts.
void resolve_all(PriorityHierarchy& hierarchy) {
  hierarchy.pairs.clear();
  for (SeparationNode& node : hierarchy.nodes) {
    node.first_pair = static_cast<std::uint32_t>(hierarchy.pairs.size());
    for_each_member(node.true_members, [&](std::uint32_t t) {
      for_each_member(node.false_members, [&](std::uint32_t f) {
        hierarchy.pairs.push_back({static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(f)});
      });
    });
    node.pair_count = static_cast<std::uint32_t>(hierarchy.pairs.size()) - node.first_pair;
  }
}

TEST(Economies, ATableMadeByHandIsCheckedWhereAMatrixHoldsIt) {
  Database boxes =
      prepare(read_environment(CIGSIM_SOURCE_DIR "/scenes/stump-reassigned.json").environment);
  ASSERT_FALSE(boxes.systems[0].hierarchy.pairs.empty());
  const std::vector<FrameView> views = slow_flight(boxes, 20);
  const SoSteps some = so_steps(boxes, views, {64, 64}, 1, 1);
  EXPECT_EQ(some.groups, 0u);
  EXPECT_EQ(some.groups_left_out, views.size());
  EXPECT_NE(some.why_not().find("made by hand"), std::string::npos);
  resolve_all(boxes.systems[0].hierarchy);
  const SoSteps all = so_steps(boxes, views, {64, 64}, 1, 1);
  EXPECT_EQ(all.groups, views.size());
  EXPECT_EQ(all.groups_left_out, 0u);
  EXPECT_GT(all.pairs, 0u);
  EXPECT_EQ(all.wrong_rows, 0u);
  EXPECT_EQ(all.why_not(), "");
}

TEST(Economies, ASceneOfOneObjectHasNoMatrixForAnotherReason) {
  const Database one = prepare(generate_environment("cubes", {1, 1}));
  const SoSteps steps = so_steps(one, slow_flight(one, 2), {64, 64}, 1, 1);
  EXPECT_EQ(steps.groups_left_out, 0u);
  EXPECT_NE(steps.why_not().find("no group has two members"), std::string::npos);
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
