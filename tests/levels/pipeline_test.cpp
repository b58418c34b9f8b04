// SPDX-License-Identifier: MIT
// The whole pipeline: the same word in the same cycle on every link whatever the levels of the
// stages, and the same picture as the functional level on machine words.
#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>

#include "models/database/prepare.hpp"
#include "models/environment/random.hpp"
#include "sim/functional_machine.hpp"
#include "sim/systemc_machine.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

// A word of a link, as far as it must agree.
struct Event {
  std::size_t word = 0;  // hash of its text
  Cycle pushed = 0, taken = 0;
  friend bool operator==(const Event&, const Event&) = default;
};
std::ostream& operator<<(std::ostream& out, const Event& event) {
  return out << event.word << " pushed " << event.pushed << " taken " << event.taken;
}
using Record = std::map<std::string, std::vector<Event>>;

struct Scene {
  Database database;
  std::vector<Viewpoint> views;
};

Scene random_scene(std::uint64_t seed, int views) {
  Random random(seed);
  World world;
  switch (random.below(8)) {
    case 0:
      world = touching_world(random);
      break;
    case 1:
      world = triangle_soup(random, 4);
      break;
    case 2:
      world = coplanar_polygons(random, 4);
      break;
    case 3:
      world = grid_boxes(random, 3);
      break;
    case 4:
      world = cell_bodies(random, 1);
      break;
    default:
      world = disjoint_world(random, 1 + static_cast<int>(random.below(30)));
  }
  Scene scene{prepare(world.environment), {}};
  for (int v = 0; v < views; ++v)
    scene.views.push_back(random_viewpoint(world.environment, random));
  return scene;
}

// A small machine whose memories now and then overflow.
MachineDescription small_machine(Random& random, OverloadPolicy policy) {
  MachineDescription machine = machine_preset("unlimited");
  machine.raster = {1 + static_cast<int>(random.below(48)), 1 + static_cast<int>(random.below(40))};
  machine.elements_per_cycle = 1 + random.below(5);
  machine.crossing_capacity = random.below(3) == 0 ? 0 : 2 + random.below(40);
  machine.edge_capacity = random.below(2) == 0 ? 0 : 1 + random.below(60);
  machine.object_capacity = random.below(3) == 0 ? 1 + random.below(10) : 0;
  machine.links = {1 + random.below(4), 1 + random.below(8), 1 + random.below(4),
                   1 + random.below(20), 1 + random.below(20)};
  // A raster of fixed time; under kExtend it may be far too short.
  if (random.below(2) == 0) {
    machine.line_cycles = 60 + random.below(60);
    machine.frame_cycles =
        machine.line_cycles * machine.raster.height +
        (policy == OverloadPolicy::kExtend ? random.below(500) : 20000 + random.below(1000));
  }
  return machine;
}

StallFunction random_stalls(std::uint64_t seed) {
  return [seed](const std::string& link, std::uint64_t word) -> Cycle {
    Random random(seed ^ std::hash<std::string>()(link) ^ word * 0x9e3779b97f4a7c15u);
    return random.below(4) == 0 ? static_cast<Cycle>(random.below(12)) : 0;
  };
}

// All stages timed, but those clocked whose bit is set (bit 0: priority processor ... bit 4: video
// processor).
LevelChoice mix(unsigned clocked) {
  LevelChoice levels;
  for (const Stage stage : kAllStages) levels[stage] = Level::kTimed;
  for (std::size_t i = 1; i < kStageCount; ++i)
    if (clocked >> (i - 1) & 1) levels[kAllStages[i]] = Level::kClocked;
  return levels;
}
constexpr unsigned kAllTimed = 0, kAllClocked = 31;

// What came out of one machine.
struct Result {
  Record record;
  std::vector<std::vector<std::uint32_t>> colours;
  std::vector<std::vector<std::uint16_t>> numbers;
  std::vector<FrameStats> stats;
};

class Run {
 public:
  Run(const std::string& name, const PipelineOptions& options, const std::deque<Scene>& scenes)
      : machine_(name, options) {
    machine_.set_probe(
        [this](const std::string& link, const std::string& word, Cycle pushed, Cycle taken) {
          result.record[link].push_back({std::hash<std::string>()(word), pushed, taken});
        });
    machine_.feed(
        [this, &scenes]() -> std::optional<FrameJob> {
          while (scene_ < scenes.size() && view_ == scenes[scene_].views.size())
            ++scene_, view_ = 0;
          if (scene_ == scenes.size()) return {};
          return FrameJob{&scenes[scene_].database, scenes[scene_].views[view_++], 0};
        },
        [this](const Picture& picture, const FrameStats& stats) {
          result.colours.push_back(picture.colours);
          result.numbers.push_back(picture.numbers);
          result.stats.push_back(stats);
        });
  }

  SystemcMachine* machine() { return &machine_; }

  Result result;

 private:
  SystemcMachine machine_;
  std::size_t scene_ = 0, view_ = 0;
};

void expect_equal(const Result& want, const Result& got) {
  for (const auto& [link, events] : want.record) {
    const auto at = got.record.find(link);
    ASSERT_NE(at, got.record.end()) << link;
    ASSERT_EQ(at->second.size(), events.size()) << link;
    for (std::size_t i = 0; i < events.size(); ++i)
      ASSERT_EQ(at->second[i], events[i]) << link << " word " << i;
  }
  ASSERT_EQ(want.colours, got.colours);
  ASSERT_EQ(want.numbers, got.numbers);
  ASSERT_EQ(want.stats.size(), got.stats.size());
  for (std::size_t f = 0; f < want.stats.size(); ++f) {
    const FrameTiming &a = *want.stats[f].timing, &b = *got.stats[f].timing;
    ASSERT_EQ(a.input, b.input) << "frame " << f;
    ASSERT_EQ(a.first_element, b.first_element) << "frame " << f;
    ASSERT_EQ(a.last_element, b.last_element) << "frame " << f;
    for (std::size_t s = 0; s < kStageCount; ++s) {
      SCOPED_TRACE(testing::Message() << "frame " << f << " " << name_of(kAllStages[s]));
      EXPECT_EQ(a.activity[s].start, b.activity[s].start);
      EXPECT_EQ(a.activity[s].finish, b.activity[s].finish);
      EXPECT_EQ(a.activity[s].idle, b.activity[s].idle);
      EXPECT_EQ(a.activity[s].stalled, b.activity[s].stalled);
      EXPECT_EQ(want.stats[f].overload->overflows[s], got.stats[f].overload->overflows[s]);
    }
    if (testing::Test::HasFailure()) FAIL();
  }
}

// Machines with other capacities and other levels, on the same scenes.
void expect_all_mixes_alike(std::uint64_t seed, OverloadPolicy policy, bool stalls, int machines,
                            int scene_count, const std::vector<unsigned>& mixes) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::deque<Scene> scenes;
  for (int s = 0; s < scene_count; ++s) scenes.push_back(random_scene(seed * 1000 + s, 2));
  std::vector<std::vector<std::unique_ptr<Run>>> runs;
  std::vector<PipelineOptions> options;
  Random random(seed);
  for (int m = 0; m < machines; ++m) {
    PipelineOptions o;
    o.description = small_machine(random, policy);
    o.overload = policy;
    if (stalls) o.stalls = random_stalls(random.bits());
    options.push_back(o);
    runs.emplace_back();
    for (const unsigned clocked : mixes) {
      o.levels = mix(clocked);
      runs.back().push_back(std::make_unique<Run>(
          "machine_" + std::to_string(m) + "_" + std::to_string(clocked), o, scenes));
    }
  }
  std::vector<SystemcMachine*> all;
  for (const auto& machine_runs : runs)
    for (const auto& run : machine_runs) all.push_back(run->machine());
  SystemcMachine::simulate(all);
  for (int m = 0; m < machines; ++m) {
    SCOPED_TRACE("machine " + std::to_string(m));
    const Result& want = runs[m][0]->result;
    ASSERT_EQ(want.stats.size(), 2 * scenes.size());
    for (std::size_t i = 1; i < mixes.size(); ++i) {
      SCOPED_TRACE("clocked stages, bit by bit: " + std::to_string(mixes[i]));
      expect_equal(want, runs[m][i]->result);
      if (testing::Test::HasFailure()) return;
    }
    // What frame 2 dropped at its deadline is a matter of time; all else is not.
    if (policy != OverloadPolicy::kExtend && options[m].description.frame_cycles > 0) continue;
    std::size_t f = 0;
    for (const Scene& scene : scenes) {
      MachineOptions functional;
      functional.number = NumberType::kMachine;
      functional.resolver = ResolverMethod::kActiveList;
      functional.description = options[m].description;
      functional.raster = functional.description.raster;
      functional.overload = policy;
      FunctionalMachine machine(scene.database, functional);
      for (const Viewpoint& view : scene.views) {
        const Picture& picture = machine.compute(view, 0);
        ASSERT_EQ(picture.colours, want.colours[f]) << "frame " << f;
        ASSERT_EQ(picture.numbers, want.numbers[f]) << "frame " << f;
        ++f;
      }
    }
  }
}

std::vector<unsigned> all_mixes() {
  std::vector<unsigned> mixes;
  for (unsigned m = 0; m < 32; ++m) mixes.push_back(m);
  return mixes;
}

TEST(Pipeline, AllThirtyTwoMixesAgreeToTheCycle) {
  expect_all_mixes_alike(1, OverloadPolicy::kDrop, false, 3, 12, all_mixes());
}
TEST(Pipeline, AllThirtyTwoMixesAgreeUnderRandomStalls) {
  expect_all_mixes_alike(2, OverloadPolicy::kCut, true, 3, 12, all_mixes());
}
TEST(Pipeline, AllThirtyTwoMixesAgreeWhenFramesAreExtended) {
  expect_all_mixes_alike(3, OverloadPolicy::kExtend, true, 3, 12, all_mixes());
}
TEST(Pipeline, TimedEqualsClockedOnManyScenes) {
  expect_all_mixes_alike(4, OverloadPolicy::kDrop, false, 4, 170, {kAllTimed, kAllClocked});
}
TEST(Pipeline, TimedEqualsClockedOnManyScenesUnderRandomStalls) {
  expect_all_mixes_alike(5, OverloadPolicy::kCut, true, 4, 170, {kAllTimed, kAllClocked});
}
TEST(Pipeline, TimedEqualsClockedOnManyScenesThatExtendTheFrame) {
  expect_all_mixes_alike(6, OverloadPolicy::kExtend, true, 4, 170, {kAllTimed, kAllClocked});
}

}  // namespace
}  // namespace cigsim::test
