// SPDX-License-Identifier: MIT
// The geometry processor: the microprogram on its data path against the functional level, bit for
// bit, and against the timed level, cycle for cycle, with words held back at random.
#include <gtest/gtest.h>

#include <deque>

#include "models/geometry_processor/clocked.hpp"
#include "models/geometry_processor/functional_words.hpp"
#include "models/geometry_processor/timed.hpp"
#include "tests/support/fresh_simulation.hpp"
#include "tests/support/random_faces.hpp"
#include "tests/support/stage_bench.hpp"

namespace cigsim::geometry_processor {
namespace {

/// Frames over two banks: what goes in.
struct Case {
  explicit Case(std::uint64_t seed) : waits(static_cast<unsigned>(seed)) {
    Random random(seed);
    machine = test::random_machine(random);
    overload = static_cast<OverloadPolicy>(random.below(3));
    for (std::uint32_t& depth : depths) depth = 1 + random.below(random.below(2) ? 2 : 20);
    const std::uint32_t most = 1 + random.below(30);
    for (std::size_t b = 0; b < 2; ++b) {
      test::RandomFaces faces(random, machine);
      for (std::size_t s = 0; s < 3; ++s) {
        memories.push_back(faces.memory(most));
        banks[b].sets[s] = &memories.back();
      }
      banks[b].view = faces.view();
    }
    for (std::uint32_t k = 0; k < kFrames; ++k) {
      starts.push_back({k});
      std::vector<ItemWord> list;
      const std::uint32_t count = random.below(2 * most);
      for (std::uint32_t i = 0; i < count; ++i)
        list.push_back({static_cast<SetId>(random.below(3)), random.below(most), false});
      list.push_back({SetId::kStatic, 0, true});
      items.insert(items.end(), list.begin(), list.end());
      lists.push_back(list);
    }
  }
  Case(const Case&) = delete;

  static constexpr std::uint32_t kFrames = 3;
  MachineDescription machine;
  OverloadPolicy overload;
  std::uint32_t depths[4] = {};
  std::deque<FaceMemory> memories;
  std::array<GeometryBank, 2> banks;
  std::vector<FrameWord> starts;
  std::vector<ItemWord> items;
  std::vector<std::vector<ItemWord>> lists;  ///< by frame
  test::Waits waits;
};

/// Takes words for ever, now and then after so long a pause that the processor must wait.
template <class T>
class SlowDrain : public sc_core::sc_module {
 public:
  SlowDrain(sc_core::sc_module_name name, Link<T>& link, const test::Waits& waits)
      : sc_module(name), link_(link), waits_(waits) {
    SC_HAS_PROCESS(SlowDrain);
    SC_THREAD(run);
  }

 private:
  void run() {
    Cycle at = -1;
    for (std::uint64_t i = 0;; ++i) {
      at = std::max(link_.available(), at + 1 + 16 * waits_(link_.name() + " drain", i));
      link_.take(at);
    }
  }
  Link<T>& link_;
  test::Waits waits_;
};

struct Bench {
  Bench(const Case& c, bool clocked, const Clock& clock)
      : start("start", c.depths[0], c.waits),
        items("items", c.depths[1], c.waits),
        edges("edges", c.depths[2], c.waits),
        faces("faces", c.depths[3], c.waits) {
    parts.make<test::Feeder<FrameWord>>(start.link, c.starts, c.waits);
    parts.make<test::Feeder<ItemWord>>(items.link, c.items, c.waits);
    parts.make<SlowDrain<EdgeWord>>(edges.link, c.waits);
    parts.make<SlowDrain<FaceWord>>(faces.link, c.waits);
    const auto report = [this](const Figures& f) { figures.push_back(f); };
    if (!clocked) {
      parts.make<Timed>(c.machine, c.overload,
                        Timed::Links{start.link, items.link, edges.link, faces.link}, c.banks,
                        report);
      return;
    }
    Clocked& stage = parts.make<Clocked>(c.machine, c.overload, clock, c.banks, report);
    stage.clock(clock.wire);
    parts.connect(clock, start.link, stage.start);
    parts.connect(clock, items.link, stage.items);
    parts.connect(clock, stage.edges, edges.link);
    parts.connect(clock, stage.faces, faces.link);
  }
  test::RecordedLink<FrameWord> start;
  test::RecordedLink<ItemWord> items;
  test::RecordedLink<EdgeWord> edges;
  test::RecordedLink<FaceWord> faces;
  std::vector<Figures> figures;
  test::Parts parts;
};

struct Totals {
  std::uint64_t faces = 0, edges = 0, clipped = 0, overflows = 0, dropped = 0, idle = 0,
                stalled = 0;
};

void expect_functional_words(const Case& c, const Bench& bench) {
  FunctionalWords functional(c.machine);
  std::vector<EdgeWord> edges;
  std::vector<FaceWord> faces;
  for (std::uint32_t k = 0; k < Case::kFrames; ++k) {
    EdgeList<MachineWord> out;
    Figures figures;
    functional.compute(c.banks[k & 1], c.lists[k], out, figures);
    for (std::uint32_t f = 0; f < out.faces.size(); ++f) {
      const RasterFace& face = out.faces[f];
      for (std::uint32_t e = 0; e < face.edge_count; ++e) {
        const Edge<MachineWord>& edge = out.edges[face.first_edge + e];
        edges.push_back({f, static_cast<std::uint16_t>(edge.first_line),
                         static_cast<std::uint16_t>(edge.end_line), edge.left, false, edge.x.raw,
                         edge.slope.raw});
      }
      const Colour& colour = face.colour;
      faces.push_back({f, false, face.object,
                       static_cast<std::uint32_t>(colour.r | colour.g << 8 | colour.b << 16)});
    }
    edges.emplace_back().end = true;
    faces.emplace_back().end = true;
    figures.frame = k;
    figures.activity = bench.figures[k].activity;
    EXPECT_EQ(figures, bench.figures[k]) << "frame " << k;
  }
  ASSERT_EQ(bench.edges.history.size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    ASSERT_EQ(bench.edges.history[i].word, edges[i]) << "edge " << i;
  ASSERT_EQ(bench.faces.history.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    ASSERT_EQ(bench.faces.history[i].word, faces[i]) << "face " << i;
}

void expect_equal(const Bench& timed, const Bench& clocked) {
  ASSERT_EQ(timed.figures.size(), Case::kFrames);
  ASSERT_EQ(clocked.figures.size(), Case::kFrames);
  EXPECT_EQ(clocked.edges.history, timed.edges.history);
  EXPECT_EQ(clocked.faces.history, timed.faces.history);
  EXPECT_EQ(clocked.start.history, timed.start.history);
  EXPECT_EQ(clocked.items.history, timed.items.history);
  for (std::size_t k = 0; k < Case::kFrames; ++k) {
    const Activity &c = clocked.figures[k].activity, &t = timed.figures[k].activity;
    EXPECT_EQ(c.start, t.start);
    EXPECT_EQ(c.finish, t.finish);
    EXPECT_EQ(c.idle, t.idle);
    EXPECT_EQ(c.stalled, t.stalled);
    EXPECT_EQ(clocked.figures[k], timed.figures[k]) << "frame " << k;
  }
}

void run_cases(std::uint64_t first, std::uint64_t count, Totals& totals) {
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<Case> cases;
  std::deque<Bench> benches;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    cases.emplace_back(seed);
    benches.emplace_back(cases.back(), false, clock);
    benches.emplace_back(cases.back(), true, clock);
  }
  clock.start();
  const auto done = [&] {
    for (const Bench& bench : benches)
      if (bench.figures.size() < Case::kFrames) return false;
    return true;
  };
  for (int i = 0; i < 2000 && !done(); ++i) sc_core::sc_start(1000 * clock.period());
  sc_core::sc_start(100 * clock.period());
  clock.stop();
  for (std::uint64_t i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed " + std::to_string(first + i));
    const Bench &timed = benches[2 * i], &clocked = benches[2 * i + 1];
    expect_equal(timed, clocked);
    const Case& c = cases[i];
    if (c.machine.frame_cycles == 0 || c.overload == OverloadPolicy::kExtend)
      expect_functional_words(c, timed);
    for (const Figures& f : timed.figures) {
      totals.faces += f.front_faces;
      totals.edges += f.edges;
      totals.clipped += f.clipped_faces;
      totals.overflows += f.overflows;
      totals.dropped += f.dropped;
      totals.idle += f.activity.idle > 0;
      totals.stalled += f.activity.stalled > 0;
    }
  }
}

TEST(GeometryProcessor, LevelsAgreeBitForBitAndToTheCycle) {
  Totals totals;
  for (std::uint64_t first = 1; first < 401 && !HasFailure(); first += 50)
    run_cases(first, 50, totals);
  EXPECT_GT(totals.faces, 5000u);
  EXPECT_GT(totals.edges, 20000u);
  EXPECT_GT(totals.clipped, 5000u);
  EXPECT_GT(totals.overflows, 50u);
  EXPECT_GT(totals.dropped, 1000u);
  EXPECT_GT(totals.idle, 100u);
  EXPECT_GT(totals.stalled, 100u);
}

// One item, a square in view, in each of three frames. By the page's costs the item's deadline is
// looked at 4 cycles after the start word, and its face's 5 + 4 * 39 + 2 later.
TEST(GeometryProcessor, TheDeadlineEndsTheList) {
  struct Want {
    Cycle frame_cycles;
    OverloadPolicy overload;
    bool dropped;
  };
  const Want wants[] = {{4, OverloadPolicy::kDrop, true},    {5, OverloadPolicy::kDrop, true},
                        {167, OverloadPolicy::kDrop, true},  {167, OverloadPolicy::kCut, true},
                        {168, OverloadPolicy::kDrop, false}, {167, OverloadPolicy::kExtend, false},
                        {0, OverloadPolicy::kDrop, false}};
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<Case> cases;
  std::deque<Bench> benches;
  for (const Want& want : wants) {
    Case& c = cases.emplace_back(1);
    c.machine = {};
    c.machine.raster = {8, 8};
    c.machine.frame_cycles = want.frame_cycles;
    if (want.frame_cycles != 0) c.machine.frame_cycles += c.machine.deadline_margin = 50;
    c.overload = want.overload;
    for (std::uint32_t& depth : c.depths) depth = 8;
    c.waits = test::Waits::none();
    FaceMemory& memory = c.memories.emplace_back();
    memory.items = {0, 1, 0, 4};
    memory.vertices = {1024, 512, 512, 1024, 512, -512, 1024, -512, -512, 1024, -512, 512};
    memory.faces = {0, 4, -(1 << 30), 0, 0, 0, 7, 0};
    memory.corners = {0, 1, 2, 3};
    for (GeometryBank& bank : c.banks) {
      bank = {};
      bank.view.raster = c.machine.raster;
      bank.view.matrix[0][0] = bank.view.matrix[2][2] = 1 << 30;
      bank.view.matrix[1][1] = -(1 << 30);
      bank.sets.fill(&memory);
    }
    c.items.clear();
    for (std::uint32_t k = 0; k < Case::kFrames; ++k) {
      c.items.push_back({});
      c.items.push_back({SetId::kStatic, 0, true});
    }
    benches.emplace_back(c, false, clock);
    benches.emplace_back(c, true, clock);
  }
  clock.start();
  sc_core::sc_start(5000 * clock.period());
  clock.stop();
  for (std::size_t i = 0; i < std::size(wants); ++i) {
    SCOPED_TRACE(i);
    expect_equal(benches[2 * i], benches[2 * i + 1]);
    for (const Figures& f : benches[2 * i].figures) {
      EXPECT_EQ(f.dropped, wants[i].dropped ? 1u : 0u);
      EXPECT_EQ(f.edges, wants[i].dropped ? 0u : 2u);
    }
  }
}

}  // namespace
}  // namespace cigsim::geometry_processor
