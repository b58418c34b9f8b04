// SPDX-License-Identifier: MIT
// The priority processor: its levels against each other to the cycle, against a list made by
// sorting counts, and Stump's worked examples through the microprogram.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/database/prepare.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/machine/scale.hpp"
#include "models/priority_processor/functional.hpp"
#include "models/priority_processor/named_faults.hpp"
#include "tests/levels/priority_bench.hpp"
#include "tests/support/fresh_simulation.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::priority_processor {
namespace {

using test::PriorityBench;
using test::PriorityCase;

// --- Hierarchies and frames made at random, and their list by the definition.

/// A tree of groups, in places more than the counters hold, in places not listable.
PriorityHierarchy random_hierarchy(Random& random, std::uint32_t& items) {
  PriorityHierarchy h;
  items = 0;
  struct Open {
    std::uint32_t group, depth;
  };
  h.groups.emplace_back();
  for (std::vector<Open> open{{0, 1}}; !open.empty();) {
    const Open at = open.front();
    open.erase(open.begin());
    Group group;
    group.first_member = static_cast<std::uint32_t>(h.members.size());
    group.member_count = 1 + random.below(random.below(8) == 0 ? 64 : 6);
    for (std::uint32_t m = 0; m < group.member_count; ++m) {
      Member member;
      member.is_group = at.depth < 4 && random.below(3) == 0 && h.groups.size() < 20;
      member.index = member.is_group ? static_cast<std::uint32_t>(h.groups.size()) : items++;
      if (member.is_group) {
        open.push_back({member.index, at.depth + 1});
        h.groups.emplace_back();
      }
      h.members.push_back(member);
    }
    group.first_node = static_cast<std::uint32_t>(h.nodes.size());
    const bool listable = random.below(3) != 0;
    for (std::uint32_t m = 0; m + 1 < group.member_count; ++m) {
      SeparationNode node;
      node.plane = static_cast<std::uint32_t>(h.planes.size());
      h.planes.push_back(
          plane_with_normal({random.between(-8, 8), random.between(-8, 8), random.between(-8, 8)},
                            {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}));
      if (listable) {  // a chain: member m before all later ones or behind
        node.true_members = std::uint64_t{1} << m;
        for (std::uint32_t f = m + 1; f < group.member_count; ++f)
          node.false_members |= std::uint64_t{1} << f;
      } else {
        node.first_pair = static_cast<std::uint32_t>(h.pairs.size());
        node.pair_count = 1 + random.below(random.below(10) == 0 ? 400 : 10);
        for (std::uint32_t p = 0; p < node.pair_count; ++p) {
          const std::uint32_t t = random.below(group.member_count);
          const std::uint32_t f =
              (t + 1 + random.below(group.member_count - 1)) % group.member_count;
          h.pairs.push_back({static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(f)});
        }
      }
      h.nodes.push_back(node);
    }
    group.node_count = static_cast<std::uint32_t>(h.nodes.size()) - group.first_node;
    h.groups[at.group] = group;
  }
  return h;
}

ActiveEnvironment random_frame(const PriorityHierarchy& h, std::uint32_t items, Random& random) {
  ActiveEnvironment active;
  active.view.eye = {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
  if (random.below(8) != 0) active.groups.push_back({0, 0, 0});
  for (std::size_t g = 0; g < active.groups.size(); ++g) {
    const Group group = h.groups[active.groups[g].group];
    std::uint64_t mask = 0;
    for (std::uint32_t m = 0; m < group.member_count; ++m)
      if (random.below(4) != 0) mask |= std::uint64_t{1} << m;
    active.groups[g].active = mask;
    active.groups[g].first_child = static_cast<std::uint32_t>(active.groups.size());
    for (std::uint32_t m = 0; m < group.member_count; ++m) {
      const Member& member = h.members[group.first_member + m];
      if ((mask >> m & 1) && member.is_group) active.groups.push_back({member.index, 0, 0});
    }
  }
  std::uint32_t piece = 0;
  for (std::uint32_t item = 0; item < items; ++item) {
    if (random.below(6) != 0) continue;
    const std::uint32_t before = random.below(3), behind = random.below(3);
    for (std::uint32_t i = 0; i < before + behind; ++i)
      active.moving.push_back({piece++, active.groups.empty() ? kNone : item, i < before, i});
  }
  return active;
}

struct Expected {
  std::vector<ItemWord> items;
  std::vector<std::uint32_t> faults;
};

/// By the definition: members sorted by count, then number.
class Definition {
 public:
  Definition(const PriorityHierarchy& h, const ActiveEnvironment& a, const ViewWords& view,
             int scale, const WordFormats& formats)
      : h_(h), a_(a), view_(view), scale_(scale), formats_(formats) {}

  Expected list(std::uint32_t ground) {
    if (a_.groups.empty())
      for (const auto& piece : a_.moving) put(SetId::kMoving, piece.item);
    else
      group(0);
    for (std::uint32_t i = 0; i < ground; ++i) put(SetId::kGround, i);
    out_.items.push_back({SetId::kStatic, 0, true});
    return out_;
  }

 private:
  void put(SetId set, std::uint32_t item) { out_.items.push_back({set, item, false}); }

  bool eye_true(const Plane& plane) const {
    const PlaneWords words = plane_words(plane, scale_, formats_);
    __extension__ using Wide = __int128;
    Wide sum = 0;
    for (int i = 0; i < 3; ++i) sum += Wide{words.normal[i]} * view_.eye[i];
    return sum >= Wide{words.distance};
  }

  void group(std::uint32_t active_index) {
    const ActiveGroup& active = a_.groups[active_index];
    const Group& group_ = h_.groups[active.group];
    const auto is_active = [&](std::uint32_t m) { return (active.active >> m & 1) != 0; };
    std::vector<int> counts(kGroupCapacity);
    std::vector<std::uint32_t> members;
    for (std::uint32_t m = 0; m < group_.member_count; ++m)
      if (is_active(m)) members.push_back(m);
    for (std::uint32_t n = 0; n < group_.node_count; ++n) {
      const SeparationNode& node = h_.nodes[group_.first_node + n];
      const bool eye = eye_true(h_.planes[node.plane]);
      const auto pair = [&](std::uint32_t t, std::uint32_t f) {
        if (is_active(t) && is_active(f)) ++counts[eye ? f : t];
      };
      for (std::uint32_t p = 0; p < node.pair_count; ++p)
        pair(h_.pairs[node.first_pair + p].true_member, h_.pairs[node.first_pair + p].false_member);
      if (node.pair_count == 0)
        for (std::uint32_t t = 0; t < 64; ++t)
          for (std::uint32_t f = 0; f < 64; ++f)
            if ((node.true_members >> t & 1) && (node.false_members >> f & 1)) pair(t, f);
    }
    for (int& c : counts) c = std::min(c, 63);
    std::stable_sort(members.begin(), members.end(),
                     [&](auto a, auto b) { return counts[a] < counts[b]; });
    for (std::size_t i = 0; i < members.size(); ++i)
      if (counts[members[i]] != static_cast<int>(i)) {
        out_.faults.push_back(active_index);
        break;
      }
    for (const std::uint32_t m : members) {
      const Member& member = h_.members[group_.first_member + m];
      if (!member.is_group) {
        item(member.index);
        continue;
      }
      std::uint32_t child = active.first_child;
      for (std::uint32_t b = 0; b < m; ++b)
        child += is_active(b) && h_.members[group_.first_member + b].is_group;
      group(child);
    }
  }

  void item(std::uint32_t index) {
    for (const auto& piece : a_.moving)
      if (piece.neighbour == index && piece.before) put(SetId::kMoving, piece.item);
    put(SetId::kStatic, index);
    for (const auto& piece : a_.moving)
      if (piece.neighbour == index && !piece.before) put(SetId::kMoving, piece.item);
  }

  const PriorityHierarchy& h_;
  const ActiveEnvironment& a_;
  const ViewWords& view_;
  int scale_;
  const WordFormats& formats_;
  Expected out_;
};

ViewWords eye_words(const Vec3& eye, int scale, const WordFormats& formats) {
  ViewWords words;
  std::uint64_t overflows = 0;
  const double eyes[3] = {eye.x, eye.y, eye.z};
  for (int i = 0; i < 3; ++i) words.eye[i] = coordinate_word(eyes[i], scale, formats, overflows);
  return words;
}

/// A case of two random frames with what is expected of them.
struct RandomCase {
  PriorityCase bench;
  Expected expected[2];

  explicit RandomCase(std::uint64_t seed) {
    Random random(seed);
    constexpr int kScale = 24;
    bench.machine.formats.direction_fraction = random.below(2) ? 30 : 14;
    bench.machine.links.items = 1 + random.below(5);
    bench.machine.object_capacity = random.below(3) == 0 ? 1 + random.below(20) : 0;
    for (Expected& e : expected) {
      std::uint32_t items = 0;  // each frame is of a database of its own
      const PriorityHierarchy h = random_hierarchy(random, items);
      bench.memories.push_back(std::make_unique<PriorityMemory>(h, items, kScale, bench.machine));
      bench.filled.emplace_back(*bench.memories.back());
      if (random.below(2))  // what a frame before has left must not matter
        bench.filled.back().fill(random_frame(h, items, random), {}, random.below(3));
      const ActiveEnvironment active = random_frame(h, items, random);
      const ViewWords view = eye_words(active.view.eye, kScale, bench.machine.formats);
      const std::uint32_t ground = random.below(3);
      bench.filled.back().fill(active, view, ground);
      e = Definition(h, active, view, kScale, bench.machine.formats).list(ground);
      const std::uint32_t capacity = bench.machine.object_capacity;
      if (capacity != 0 && e.items.size() - 1 > capacity)
        e.items.erase(e.items.begin() + capacity, e.items.end() - 1);
    }
    bench.frames = 4;
    bench.start_gap = random.below(2) ? 0 : random.below(3000);
    bench.pauses = random.below(3) == 0 ? 0 : random.bits();
  }
};

TEST(PriorityProcessor, LevelsAgreeToTheCycleAndWithTheDefinition) {
  constexpr std::uint64_t kCases = 60;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<RandomCase> cases;
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
    const RandomCase& c = cases[i];
    const PriorityBench &timed = benches[2 * i], &clocked = benches[2 * i + 1];
    ASSERT_TRUE(timed.done() && clocked.done());
    std::vector<ItemWord> all;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const Expected& e = c.expected[k & 1];
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

bool clear_of_planes(const PriorityHierarchy& h, const Vec3& eye, int scale) {
  for (const Plane& plane : h.planes) {
    const Vec3 n = plane.normal, d = eye - plane.exact.p;
    const double distance = std::abs(dot(n, d)) / std::sqrt(dot(n, n));
    if (std::ldexp(distance, scale) < 16) return false;
  }
  return true;
}

TEST(PriorityProcessor, PreparedWorldsAreListedAsWithExactPlanes) {
  constexpr std::uint64_t kCases = 12;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<PriorityCase> cases;
  std::deque<std::vector<PriorityList>> expected;
  std::deque<PriorityBench> benches;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    Random random(seed);
    const test::World world =
        seed % 2 ? test::touching_world(random)
                 : test::disjoint_world(random, 3 + static_cast<int>(random.below(40)));
    const Database database = prepare(world.environment);
    const PreparedSystem& system = database.systems[0];
    PriorityCase& c = cases.emplace_back();
    const int scale = coordinate_scale(database, c.machine.formats);
    c.memories.push_back(std::make_unique<PriorityMemory>(system.hierarchy, system.set.items.size(),
                                                          scale, c.machine));
    c.pauses = seed % 3 == 0 ? 0 : seed;
    auto& lists = expected.emplace_back();
    const frame_calculator::Functional calculator(database);
    while (c.filled.size() < 2) {
      ActiveEnvironment active;
      FaceSet moving;
      calculator.compute(test::plain_viewpoint(world.environment, random), {64, 64}, 0, active,
                         moving);
      std::uint64_t overflows = 0;
      const ViewWords view = view_words(active.view, scale, c.machine.formats, overflows);
      if (overflows != 0 || !clear_of_planes(system.hierarchy, active.view.eye, scale)) continue;
      Functional<double> functional(Method::kCounters);
      functional.compute(system.hierarchy, system.set, active, database.ground,
                         lists.emplace_back());
      c.filled.emplace_back(*c.memories[0]);
      c.filled.back().fill(active, view, static_cast<std::uint32_t>(database.ground.items.size()));
    }
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
    for (const PriorityList& list : expected[i]) {
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

struct TablePlane {
  Vec3 normal, point;
  std::vector<MemberPair> pairs;  ///< objects from 0
};

/// Objects 0 to n - 1 in one group with hand-written pairs.
PriorityHierarchy table_hierarchy(std::uint32_t objects, const std::vector<TablePlane>& planes) {
  PriorityHierarchy h;
  h.groups.push_back({0, objects, 0, static_cast<std::uint32_t>(planes.size())});
  for (std::uint32_t m = 0; m < objects; ++m) h.members.push_back({false, m, {}});
  for (const TablePlane& plane : planes) {
    SeparationNode node;
    node.plane = static_cast<std::uint32_t>(h.planes.size());
    node.first_pair = static_cast<std::uint32_t>(h.pairs.size());
    node.pair_count = static_cast<std::uint32_t>(plane.pairs.size());
    h.planes.push_back(plane_with_normal(plane.point, plane.normal));
    h.pairs.insert(h.pairs.end(), plane.pairs.begin(), plane.pairs.end());
    h.nodes.push_back(node);
  }
  return h;
}

constexpr int kTableScale = 20;

/// The same, seen from `eye`.
PriorityCase table_case(std::uint32_t objects, const std::vector<TablePlane>& planes,
                        const Vec3& eye) {
  const PriorityHierarchy h = table_hierarchy(objects, planes);
  PriorityCase c;
  c.memories.push_back(std::make_unique<PriorityMemory>(h, objects, kTableScale, c.machine));
  ActiveEnvironment active;
  active.groups.push_back({0, (std::uint64_t{1} << objects) - 1, 1});
  c.filled.assign(2, PriorityBank(*c.memories[0]));
  for (PriorityBank& bank : c.filled)
    bank.fill(active, eye_words(eye, kTableScale, c.machine.formats), 0);
  c.frames = 1;
  return c;
}

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

constexpr std::uint8_t A = 0, B = 1, C = 2, D = 3;
constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0};

/// Stump's Fig. 7, as far as its table goes.
const std::vector<TablePlane> kFig7{{kX, {10, 0, 0}, {{C, B}, {D, A}}},
                                    {kY, {0, 10, 0}, {{B, D}, {C, A}}},
                                    {{0, 0, 1}, {0, 0, 10}, {{B, A}, {D, C}}}};

// The eye at the origin is FALSE on planes whose normals point away from it.
TEST(StumpThroughTheMicroprogram, Fig7CountsAfterEachPlaneAndItsFault) {
  std::deque<PriorityCase> cases;
  for (std::size_t n = 1; n <= 3; ++n)
    cases.push_back(table_case(4, {kFig7.begin(), kFig7.begin() + static_cast<long>(n)}, {}));
  const std::vector<TablePlane> reassigned{{kX, {10, 0, 0}, {{C, A}, {C, B}}},
                                           {kY, {0, 10, 0}, {{D, A}, {D, B}}},
                                           {{0, 0, 1}, {0, 0, 10}, {{B, A}, {D, C}}}};
  cases.push_back(table_case(4, reassigned, {}));
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
  const std::vector<TablePlane> planes{{kX, {10, 0, 0}, {{1, 0}}}};
  std::deque<PriorityCase> cases;
  for (const double x : {11.0, 10.0, 9.0}) cases.push_back(table_case(2, planes, {x, 3, 4}));
  const auto results = run_tables(cases, 2);
  EXPECT_EQ(results[0], (TableResult{"10", "10", false}));
  EXPECT_EQ(results[1], (TableResult{"10", "10", false})) << "on the plane counts as TRUE";
  EXPECT_EQ(results[2], (TableResult{"01", "01", false}));
}

TEST(StumpThroughTheMicroprogram, TestCase2InItsFourRegions) {
  const std::vector<TablePlane> planes{{{-1, 0, 0}, {60, 0, 0}, {{2, 0}, {2, 1}, {3, 0}, {3, 1}}},
                                       {{1, 1, 0}, {10, 10, 0}, {{3, 2}, {1, 0}}}};
  std::deque<PriorityCase> cases;
  for (const Vec3& eye : {Vec3{50, 0, 0}, Vec3{0, 0, 0}, Vec3{70, 0, 0}, Vec3{70, -70, 0}})
    cases.push_back(table_case(4, planes, eye));
  const auto results = run_tables(cases, 4);
  // TRUE on the first plane: 3 and 4 before 1 and 2; TRUE on the second: 2 before 1, 4 before 3.
  EXPECT_EQ(results[0], (TableResult{"3210", "3210", false}));
  EXPECT_EQ(results[1], (TableResult{"2301", "2301", false}));
  EXPECT_EQ(results[2], (TableResult{"1032", "1032", false}));
  EXPECT_EQ(results[3], (TableResult{"0123", "0123", false}));
}

TEST(StumpThroughTheMicroprogram, TestCase3InItsNineRegions) {
  const std::vector<TablePlane> planes{{kX, {25, 0, 0}, {{4, 0}, {4, 1}, {4, 2}, {4, 3}}},
                                       {kY, {0, 25, 0}, {{3, 0}, {3, 1}, {3, 2}}},
                                       {kX, {10, 0, 0}, {{2, 0}, {2, 1}}},
                                       {kY, {0, 10, 0}, {{1, 0}}}};
  std::deque<PriorityCase> cases;
  for (const double x : {5.0, 20.0, 30.0})
    for (const double y : {5.0, 20.0, 30.0}) cases.push_back(table_case(5, planes, {x, y, 0}));
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
  const PriorityCase c = table_case(2, {{kX, {10, 0, 0}, {{1, 0}}}}, {});
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
  const PriorityCase c = table_case(2, {{kX, {10, 0, 0}, {{1, 0}}}}, {});
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
