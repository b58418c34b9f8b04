// SPDX-License-Identifier: MIT
// The priority processor: its levels against each other to the cycle, against a list made by
// sorting counts, and Stump's worked examples through the microprogram.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/priority_processor/functional_words.hpp"
#include "models/priority_processor/named_faults.hpp"
#include "tests/levels/priority_bench.hpp"
#include "tests/levels/priority_random_case.hpp"
#include "tests/levels/priority_table_case.hpp"
#include "tests/levels/priority_world_case.hpp"
#include "tests/support/fresh_simulation.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim::priority_processor {
namespace {

using namespace test::stump;
using test::kTableScale;
using test::PriorityBench;
using test::PriorityCase;
using test::PriorityRandomCase;
using test::table_case;
using test::table_hierarchy;

TEST(PriorityProcessor, LevelsAgreeToTheCycleAndWithTheDefinition) {
  constexpr std::uint64_t kCases = 60;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<PriorityRandomCase> cases;
  std::deque<PriorityBench> benches;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    cases.emplace_back(seed);
    benches.emplace_back(cases.back().bench, PriorityBench::kTimed, clock);
    benches.emplace_back(cases.back().bench, PriorityBench::kClocked, clock);
  }
  test::run_benches(clock, benches, 2'000'000);
  std::size_t faults = 0, drops = 0, stalls = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    SCOPED_TRACE("seed " + std::to_string(i + 1));
    const PriorityRandomCase& c = cases[i];
    const PriorityBench &timed = benches[2 * i], &clocked = benches[2 * i + 1];
    ASSERT_TRUE(timed.done() && clocked.done());
    std::vector<ItemWord> all;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const test::ExpectedItems& e = c.expected[k & 1];
      all.insert(all.end(), e.items.begin(), e.items.end());
      std::vector<ItemWord> items;
      Figures figures;
      FunctionalWords(c.bench.machine.object_capacity)
          .compute(c.bench.filled[k & 1], items, figures);
      EXPECT_EQ(items, e.items) << "functional, frame " << k;
      EXPECT_EQ(figures.faults, e.faults) << "frame " << k;
      EXPECT_EQ(figures.items, e.items.size() - 1);
      figures.frame = k;
      figures.activity = timed.figures[k].activity;
      EXPECT_EQ(figures, timed.figures[k]) << "frame " << k;
      EXPECT_EQ(clocked.figures[k].activity.start, timed.figures[k].activity.start);
      EXPECT_EQ(clocked.figures[k].activity.finish, timed.figures[k].activity.finish);
      EXPECT_EQ(clocked.figures[k].activity.stalled, timed.figures[k].activity.stalled);
      EXPECT_EQ(clocked.figures[k], timed.figures[k]) << "frame " << k;
      faults += e.faults.size();
      drops += figures.dropped;
      stalls += figures.activity.stalled > 0;
    }
    ASSERT_EQ(timed.history.size(), all.size());
    for (std::size_t n = 0; n < all.size(); ++n) ASSERT_EQ(timed.history[n].word, all[n]);
    ASSERT_EQ(clocked.history, timed.history);
  }
  EXPECT_GT(faults, 20u);
  EXPECT_GT(drops, 20u);
  EXPECT_GT(stalls, 20u);
}

// --- Prepared worlds: the list is that of exact planes wherever the eye is clear of them.

TEST(PriorityProcessor, PreparedWorldsAreListedAsWithExactPlanes) {
  constexpr std::uint64_t kCases = 12;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<test::PriorityWorldCase> cases;
  std::deque<PriorityBench> benches;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    const PriorityCase& c = cases.emplace_back(seed).bench;
    benches.emplace_back(c, PriorityBench::kTimed, clock);
    benches.emplace_back(c, PriorityBench::kClocked, clock);
  }
  test::run_benches(clock, benches, 3'000'000);
  std::size_t items = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    SCOPED_TRACE("seed " + std::to_string(i + 1));
    const PriorityBench &timed = benches[2 * i], &clocked = benches[2 * i + 1];
    ASSERT_TRUE(timed.done() && clocked.done());
    std::size_t at = 0;
    for (const PriorityList& list : cases[i].expected) {
      items += list.items.size();
      for (const ItemRef& item : list.items) {
        ASSERT_LT(at, timed.history.size());
        ASSERT_EQ(timed.history[at++].word, (ItemWord{item.set, item.item, false}));
      }
      ASSERT_TRUE(timed.history[at++].word.end);
    }
    EXPECT_EQ(clocked.history, timed.history);
    EXPECT_EQ(clocked.figures, timed.figures);
  }
  EXPECT_GT(items, 100u);
}

// --- Stump's worked examples, through the microprogram.

struct TableResult {
  std::string counts;  ///< of objects 0, 1, …, a digit each
  std::string list;    ///< the items as they come
  bool fault = false;
  friend bool operator==(const TableResult&, const TableResult&) = default;
};
void PrintTo(const TableResult& r, std::ostream* out) {
  *out << "counts " << r.counts << " list " << r.list << (r.fault ? " fault" : "");
}

std::vector<TableResult> run_tables(const std::deque<PriorityCase>& cases, std::uint32_t objects) {
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<PriorityBench> benches;
  for (const PriorityCase& c : cases) benches.emplace_back(c, PriorityBench::kClocked, clock);
  test::run_benches(clock, benches, 10'000);
  std::vector<TableResult> results;
  for (const PriorityBench& bench : benches) {
    TableResult& r = results.emplace_back();
    EXPECT_TRUE(bench.done());
    for (std::uint32_t m = 0; m < objects; ++m)
      r.counts += static_cast<char>('0' + bench.clocked->counts()[m]);
    for (const auto& h : bench.history)
      if (!h.word.end) r.list += static_cast<char>('0' + h.word.item);
    r.fault = !bench.figures.at(0).faults.empty();
  }
  return results;
}

TEST(StumpThroughTheMicroprogram, Fig7CountsAfterEachPlaneAndItsFault) {
  std::deque<PriorityCase> cases;
  for (std::size_t n = 1; n <= 3; ++n)
    cases.push_back(table_case(4, {kFig7.begin(), kFig7.begin() + static_cast<long>(n)}, {}));
  cases.push_back(table_case(4, kFig7Reassigned, {}));
  const auto results = run_tables(cases, 4);
  EXPECT_EQ(results[0], (TableResult{"0011", "0123", true}));
  EXPECT_EQ(results[1], (TableResult{"0121", "0132", true}));
  EXPECT_EQ(results[2], (TableResult{"0222", "0123", true}));
  EXPECT_EQ(results[3], (TableResult{"0123", "0123", false}));
}

TEST(StumpThroughTheMicroprogram, Fig7sFaultIsNamedByItsCircuit) {
  const PriorityCase c = table_case(4, kFig7, {});
  std::vector<ItemWord> items;
  Figures figures;
  FunctionalWords(0).compute(c.filled[0], items, figures);
  FaceSet objects;
  for (std::uint32_t m = 0; m < 4; ++m) {
    objects.faces.push_back({0, 0, 0, m + 1, {}, false});
    objects.items.push_back({m, 1, 0, 0, {}});
  }
  ActiveEnvironment active;
  active.groups.push_back({0, 15, 1});
  const auto faults = named_faults(table_hierarchy(4, kFig7), objects, active, {}, kTableScale,
                                   c.machine.formats, figures.faults);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].circuit, (std::vector<std::uint32_t>{B + 1, C + 1, D + 1}));
}

TEST(StumpThroughTheMicroprogram, TestCase1) {
  std::deque<PriorityCase> cases;
  for (const double x : {11.0, 10.0, 9.0}) cases.push_back(table_case(2, kTestCase1, {x, 3, 4}));
  const auto results = run_tables(cases, 2);
  EXPECT_EQ(results[0], (TableResult{"10", "10", false}));
  EXPECT_EQ(results[1], (TableResult{"10", "10", false})) << "on the plane counts as TRUE";
  EXPECT_EQ(results[2], (TableResult{"01", "01", false}));
}

TEST(StumpThroughTheMicroprogram, TestCase2InItsFourRegions) {
  std::deque<PriorityCase> cases;
  for (const Vec3& eye : {Vec3{50, 0, 0}, Vec3{0, 0, 0}, Vec3{70, 0, 0}, Vec3{70, -70, 0}})
    cases.push_back(table_case(4, kTestCase2, eye));
  const auto results = run_tables(cases, 4);
  // TRUE on the first plane: 3 and 4 before 1 and 2; TRUE on the second: 2 before 1, 4 before 3.
  EXPECT_EQ(results[0], (TableResult{"3210", "3210", false}));
  EXPECT_EQ(results[1], (TableResult{"2301", "2301", false}));
  EXPECT_EQ(results[2], (TableResult{"1032", "1032", false}));
  EXPECT_EQ(results[3], (TableResult{"0123", "0123", false}));
}

TEST(StumpThroughTheMicroprogram, TestCase3InItsNineRegions) {
  std::deque<PriorityCase> cases;
  for (const double x : {5.0, 20.0, 30.0})
    for (const double y : {5.0, 20.0, 30.0}) cases.push_back(table_case(5, kTestCase3, {x, y, 0}));
  std::vector<std::string> counts;
  for (const TableResult& r : run_tables(cases, 5)) {
    EXPECT_FALSE(r.fault);
    counts.push_back(r.counts);
  }
  std::sort(counts.begin(), counts.end());
  EXPECT_EQ(counts, (std::vector<std::string>{"01234", "10234", "12034", "21034", "21304", "23140",
                                              "32104", "32140", "43210"}));
}

// --- Rules and refusals.

// docs/machine/priority_processor.md, "Timing rules": the example, counted by hand from PP7 to
// PP9.
TEST(PriorityProcessor, TheExampleOfTheManualTakesTheCyclesThatItSays) {
  test::fresh_simulation();
  Clock clock("clock", 125);
  const PriorityCase c = table_case(2, kTestCase1, {});
  std::deque<PriorityBench> benches;
  benches.emplace_back(c, PriorityBench::kTimed, clock);
  benches.emplace_back(c, PriorityBench::kClocked, clock);
  test::run_benches(clock, benches, 1000);
  for (const PriorityBench& bench : benches) {
    ASSERT_EQ(bench.history.size(), 3u);
    const Cycle start = bench.figures.at(0).activity.start;
    EXPECT_EQ(start, 1) << "pushed in cycle 0";
    EXPECT_EQ(bench.history[0].pushed - start, 33);
    EXPECT_EQ(bench.history[1].pushed - start, 38);
    EXPECT_EQ(bench.history[2].pushed - start, 44);
    EXPECT_EQ(bench.figures[0].activity, (Activity{1, 45, 0, 0}));
  }
}

TEST(PriorityProcessor, WavesHaveThePinsAndTheMicroprogramsAddress) {
  test::fresh_simulation();
  const test::Scratch scratch;
  const std::string file = scratch.path("wave").string();
  Clock clock("clock", 125);
  const PriorityCase c = table_case(2, kTestCase1, {});
  std::deque<PriorityBench> benches;
  benches.emplace_back(c, PriorityBench::kClocked, clock);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  sc_core::sc_trace_file* trace = sc_core::sc_create_vcd_trace_file(file.c_str());
  benches[0].clocked->trace(trace);
  test::run_benches(clock, benches, 1000);
  sc_core::sc_close_vcd_trace_file(trace);
  const std::string wave = test::bytes_of(file + ".vcd");
  for (const char* name : {"items_valid", "items_word", "start_ready", "microaddress", "bar"})
    EXPECT_NE(wave.find(name), std::string::npos) << name;
}

TEST(PriorityMemory, RefusesWhatExceedsTheMachine) {
  PriorityHierarchy h;
  for (std::uint32_t g = 0; g < 5; ++g) {
    h.groups.push_back({g, 1, 0, 0});
    h.members.push_back({g < 4, g < 4 ? g + 1 : 0, {}});
  }
  MachineDescription machine;
  machine.name = "small";
  EXPECT_EQ(PriorityMemory(h, 1, 0, machine).depth, 5u);
  machine.hierarchy_depth = 5;
  EXPECT_EQ(PriorityMemory(h, 1, 0, machine).depth, 5u);
  machine.hierarchy_depth = 4;
  try {
    PriorityMemory(h, 1, 0, machine);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "the scene's priority hierarchy has 5 levels of groups, and machine 'small' has 4 "
                 "(hierarchy_depth); take a simpler scene or another machine");
  }
  machine.hierarchy_depth = 0;
  h.planes.push_back(axis_plane(0, 1));
  h.pairs.assign(4097, {0, 1});
  h.nodes.push_back({0, 0, 0, 0, 0, 0, 4097});
  h.groups[0].node_count = 1;
  EXPECT_THROW(PriorityMemory(h, 1, 0, machine), std::invalid_argument);
}

// The distance against the real line: N.P for the words of N, within half a unit.
TEST(PriorityMemory, DistancesAreExactForTheRoundedNormal) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto value = [&] { return random.between(-1, 1); };
    const Vec3 p{1000 * value(), 1000 * value(), 1000 * value()}, n{value(), value(), value()};
    WordFormats formats;
    formats.direction_fraction = random.below(2) ? 30 : 14;
    constexpr int kScale = 19;
    const PlaneWords words = plane_words(plane_with_normal(p, n), kScale, formats);
    const double length = std::sqrt(dot(n, n));
    const double normal[3] = {n.x / length, n.y / length, n.z / length}, point[3] = {p.x, p.y, p.z};
    long double exact = 0;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(words.normal[i], std::ldexp(normal[i], 30),
                  std::ldexp(0.5001, 30 - formats.direction_fraction));
      exact += static_cast<long double>(words.normal[i]) * std::ldexp(point[i], kScale);
    }
    EXPECT_NEAR(static_cast<double>(static_cast<long double>(words.distance) - exact), 0, 0.6);
  }
}

TEST(PriorityMemory, PlanesFarOutsideSaturateAndZeroNormalsAreTrue) {
  const WordFormats formats;
  EXPECT_EQ(plane_words(axis_plane(0, 1e30), 0, formats).distance, Accumulator{1} << 62);
  EXPECT_EQ(plane_words(axis_plane(0, -1e30), 0, formats).distance, -(Accumulator{1} << 62));
  EXPECT_EQ(plane_words(plane_with_normal({5, 1e30, -1e30}, {2, 0, 0}), 0, formats).distance,
            Accumulator{5} << 30);
  EXPECT_EQ(
      std::abs(plane_words(plane_with_normal({1e30, 1e30, 0}, {1, -1, 0}), 0, formats).distance),
      0);
  const PlaneWords none = plane_words(make_plane({}), 0, formats);
  EXPECT_EQ(none.normal[0] | none.normal[1] | none.normal[2], 0);
  EXPECT_EQ(none.distance, 0);
}

}  // namespace
}  // namespace cigsim::priority_processor
