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
#include "sim/scene.hpp"
#include "sim/systemc_machine.hpp"
#include "sim/view.hpp"
#include "tests/support/fresh_simulation.hpp"
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
  std::vector<FrameJob> jobs;
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
    scene.jobs.push_back({nullptr, random_viewpoint(world.environment, random), 0});
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
        (policy == OverloadPolicy::kExtend ? random.below(500) : 2000 + random.below(2000));
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

// Every test simulates anew.
class Pipeline : public testing::Test {
 protected:
  Pipeline() { fresh_simulation(); }
};

class Pipe {
 public:
  Pipe(const std::string& name, const PipelineOptions& options, const std::deque<Scene>& scenes)
      : machine_(name, options) {
    machine_.set_probe(
        [this](const std::string& link, const std::string& word, Cycle pushed, Cycle taken) {
          result.record[link].push_back({std::hash<std::string>()(word), pushed, taken});
        });
    machine_.feed(
        [this, &scenes]() -> std::optional<FrameJob> {
          while (scene_ < scenes.size() && job_ == scenes[scene_].jobs.size()) ++scene_, job_ = 0;
          if (scene_ == scenes.size()) return {};
          FrameJob job = scenes[scene_].jobs[job_++];
          job.database = &scenes[scene_].database;
          return job;
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
  std::size_t scene_ = 0, job_ = 0;
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

// What the machines met; a test that met nothing would prove nothing.
struct Met {
  std::uint64_t dropped_items = 0, dropped_faces = 0, dropped_crossings = 0, late_lines = 0,
                idle = 0, stalled = 0;
  void add(const FrameStats& stats) {
    dropped_items += stats.overload->dropped_items;
    dropped_faces += stats.overload->dropped_faces;
    dropped_crossings += stats.overload->dropped_crossings;
    late_lines += stats.overload->late_lines;
    for (const Activity& activity : stats.timing->activity) {
      idle += static_cast<std::uint64_t>(activity.idle);
      stalled += static_cast<std::uint64_t>(activity.stalled);
    }
  }
};

// The pictures of the functional level on machine words.
void expect_functional_pictures(const std::deque<Scene>& scenes, const PipelineOptions& options,
                                const Result& result) {
  std::size_t f = 0;
  for (const Scene& scene : scenes) {
    MachineOptions functional;
    functional.number = NumberType::kMachine;
    functional.resolver = ResolverMethod::kActiveList;
    functional.description = options.description;
    functional.raster = functional.description.raster;
    functional.overload = options.overload;
    FunctionalMachine machine(scene.database, functional);
    for (const FrameJob& job : scene.jobs) {
      const Picture& picture = machine.compute(job.viewpoint, job.position);
      ASSERT_EQ(picture.colours, result.colours[f]) << "frame " << f;
      ASSERT_EQ(picture.numbers, result.numbers[f]) << "frame " << f;
      EXPECT_EQ(machine.stats().faults, result.stats[f].faults) << "frame " << f;
      EXPECT_EQ(machine.stats().spans, result.stats[f].spans) << "frame " << f;
      ++f;
    }
  }
}

// Machines of other sizes, each on scenes of its own, at all 32 mixes of levels.
Met expect_all_mixes_alike(std::uint64_t seed, OverloadPolicy policy, bool stalls, int machines,
                           int scenes_each) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::deque<std::deque<Scene>> scenes(machines);
  std::vector<std::vector<std::unique_ptr<Pipe>>> runs(machines);
  std::vector<PipelineOptions> options(machines);
  std::vector<SystemcMachine*> all;
  Random random(seed);
  for (int m = 0; m < machines; ++m) {
    for (int s = 0; s < scenes_each; ++s)
      scenes[m].push_back(random_scene(seed * 100000 + m * 1000 + s, 1));
    options[m].description = small_machine(random, policy);
    options[m].overload = policy;
    if (stalls) options[m].stalls = random_stalls(random.bits());
    for (unsigned clocked = 0; clocked < 32; ++clocked) {
      options[m].levels = mix(clocked);
      runs[m].push_back(std::make_unique<Pipe>(
          "machine_" + std::to_string(m) + "_" + std::to_string(clocked), options[m], scenes[m]));
      all.push_back(runs[m].back()->machine());
    }
  }
  SystemcMachine::simulate(all);
  Met met;
  for (int m = 0; m < machines; ++m) {
    SCOPED_TRACE("machine " + std::to_string(m));
    const Result& want = runs[m][0]->result;
    EXPECT_EQ(want.stats.size(), scenes[m].size());
    for (const FrameStats& stats : want.stats) met.add(stats);
    for (unsigned clocked = 1; clocked < 32; ++clocked) {
      SCOPED_TRACE("clocked stages, bit by bit: " + std::to_string(clocked));
      expect_equal(want, runs[m][clocked]->result);
      if (testing::Test::HasFailure()) return met;
    }
    // What frame 2 drops at its deadline is a matter of time; all else is not.
    if (policy == OverloadPolicy::kExtend || options[m].description.frame_cycles == 0)
      expect_functional_pictures(scenes[m], options[m], want);
    if (testing::Test::HasFailure()) return met;
  }
  return met;
}

// Together more than 1,000 scenes.
TEST_F(Pipeline, AllMixesOfLevelsAgreeToTheCycle) {
  const Met met = expect_all_mixes_alike(1, OverloadPolicy::kDrop, false, 12, 29);
  EXPECT_GT(met.dropped_items, 0u);
  EXPECT_GT(met.dropped_faces, 0u);
  EXPECT_GT(met.dropped_crossings, 0u);
}
TEST_F(Pipeline, AllMixesOfLevelsAgreeUnderRandomStalls) {
  const Met met = expect_all_mixes_alike(2, OverloadPolicy::kCut, true, 12, 29);
  EXPECT_GT(met.dropped_crossings, 0u);
  EXPECT_GT(met.idle, 0u);
  EXPECT_GT(met.stalled, 0u);
}
TEST_F(Pipeline, AllMixesOfLevelsAgreeWhenFramesAreExtended) {
  const Met met = expect_all_mixes_alike(3, OverloadPolicy::kExtend, true, 12, 29);
  EXPECT_EQ(met.dropped_crossings, 0u);
  EXPECT_GT(met.late_lines, 0u);
}

// A flight: the airfield's approach with its moving aircraft, on a small raster.
TEST_F(Pipeline, TheApproachIsTheSameFlightAtEveryLevel) {
  ViewOptions view;
  view.path = "builtin";
  view.frames = 24;
  std::deque<Scene> scenes;
  scenes.push_back({load_scene({}, {}).database, {}});
  for (const FrameView& at : frame_views(view, load_path(view), scenes[0].database))
    scenes[0].jobs.push_back({&scenes[0].database, at.viewpoint, at.position});
  PipelineOptions options;
  options.description = with_raster(machine_preset("asupt1975"), {160, 120});
  std::vector<std::unique_ptr<Pipe>> runs;
  std::vector<SystemcMachine*> all;
  for (const unsigned clocked : {kAllTimed, kAllClocked}) {
    options.levels = mix(clocked);
    runs.push_back(std::make_unique<Pipe>("flight_" + std::to_string(clocked), options, scenes));
    all.push_back(runs.back()->machine());
  }
  SystemcMachine::simulate(all);
  ASSERT_EQ(runs[0]->result.stats.size(), 24u);
  expect_equal(runs[0]->result, runs[1]->result);
  expect_functional_pictures(scenes, options, runs[0]->result);
}

// Stump's four objects in a ring: the fault is raised, the circuit named, and a picture comes out.
TEST_F(Pipeline, AFaultIsRaisedNamedAndShown) {
  std::deque<Scene> scenes;
  scenes.push_back(
      {load_scene(CIGSIM_SOURCE_DIR "/scenes/stump-not-listable.json", {}).database, {}});
  const ViewOptions view;
  for (const FrameView& at : frame_views(view, {}, scenes[0].database))
    scenes[0].jobs.push_back({&scenes[0].database, at.viewpoint, at.position});
  PipelineOptions options;
  options.description = with_raster(machine_preset("asupt1975"), {64, 64});
  options.levels = mix(kAllClocked);
  Pipe run("stump", options, scenes);
  SystemcMachine::simulate({run.machine()});
  ASSERT_EQ(run.result.stats.size(), 1u);
  const FrameStats& stats = run.result.stats[0];
  EXPECT_EQ(stats.faults, 1u);
  ASSERT_EQ(stats.listability.size(), 1u);
  EXPECT_EQ(stats.listability[0].circuit, (std::vector<std::uint32_t>{2, 3, 4}));
  expect_functional_pictures(scenes, options, run.result);
}

}  // namespace
}  // namespace cigsim::test
