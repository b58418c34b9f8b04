// SPDX-License-Identifier: MIT
// Tables made by hand, from the scene to the list: Stump's three cases and his table that is not
// listable, random tables against brute force, and what the preparation refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "models/database/prepare.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/random.hpp"
#include "models/environment/read.hpp"
#include "models/environment/shapes.hpp"
#include "models/priority_processor/functional.hpp"
#include "sim/functional_machine.hpp"

namespace cigsim {
namespace {

using priority_processor::Functional;
using priority_processor::GroupOrder;
using priority_processor::Method;

Environment shipped(const std::string& file) {
  return read_environment(CIGSIM_SOURCE_DIR "/scenes/" + file).environment;
}

Environment boxes(const std::vector<std::pair<Vec3, Vec3>>& extents) {
  Environment environment;
  environment.models.push_back({"model", 0});
  for (const auto& [low, high] : extents) environment.objects.push_back(box(low, high));
  return environment;
}

// The list from an eyepoint with every object in view.
PriorityList list_from(const Database& database, const Vec3& eye, Method method) {
  const PreparedSystem& world = database.systems[0];
  ActiveEnvironment active;
  active.view.eye = eye;
  active.groups.push_back({0, (std::uint64_t{1} << world.set.items.size()) - 1, 0});
  PriorityList list;
  Functional<double>(method).compute(world.hierarchy, world.set, active, database.ground, list);
  return list;
}

// The digits of the places of objects 1, 2, ... in the list.
std::string counts_from(const Database& database, const Vec3& eye) {
  std::string counts;
  for (const Method method : {Method::kCounters, Method::kSoMatrix}) {
    const PriorityList list = list_from(database, eye, method);
    EXPECT_TRUE(list.faults.empty());
    std::string text(list.items.size(), '?');
    for (std::size_t place = 0; place < list.items.size(); ++place)
      text[list.items[place].item] = static_cast<char>('0' + place);
    if (!counts.empty()) {
      EXPECT_EQ(text, counts) << "both methods";
    }
    counts = text;
  }
  return counts;
}

TEST(SeparationTable, StumpsFirstCaseInItsTwoRegions) {
  Environment environment = shipped("stump-case-1.deck");
  environment.separation = {{{1, 0, 0}, 10, {{2, 1}}}};
  const Database database = prepare(environment);
  EXPECT_EQ(database.report.pairs, 1u);
  EXPECT_EQ(counts_from(database, {15, 5, 50}), "10");
  EXPECT_EQ(counts_from(database, {10, 5, 50}), "10") << "on the plane counts as TRUE";
  EXPECT_EQ(counts_from(database, {9, 5, 50}), "01");
}

TEST(SeparationTable, StumpsSecondCaseInItsFourRegions) {
  Environment environment = shipped("stump-case-2.deck");
  // He prints the second normal as (0.7, 0.7, 0) and 14.1: x + y = 20.
  environment.separation = {{{-1, 0, 0}, -60, {{3, 1}, {3, 2}, {4, 1}, {4, 2}}},
                            {{1, 1, 0}, 20, {{4, 3}, {2, 1}}}};
  const Database database = prepare(environment);
  EXPECT_EQ(database.report.pairs, 6u);
  EXPECT_EQ(database.report.planes, 2u);
  EXPECT_EQ(counts_from(database, {0, -200, 10}), "2301");
  EXPECT_EQ(counts_from(database, {0, 200, 10}), "3210");
  EXPECT_EQ(counts_from(database, {100, 0, 10}), "1032");
  EXPECT_EQ(counts_from(database, {100, -200, 10}), "0123");
}

TEST(SeparationTable, StumpsThirdCaseInItsNineRegions) {
  Environment environment = shipped("stump-case-3.deck");
  environment.separation = {{{1, 0, 0}, 25, {{5, 1}, {5, 2}, {5, 3}, {5, 4}}},
                            {{0, 1, 0}, 25, {{4, 1}, {4, 2}, {4, 3}}},
                            {{1, 0, 0}, 10, {{3, 1}, {3, 2}}},
                            {{0, 1, 0}, 10, {{2, 1}}}};
  const Database database = prepare(environment);
  EXPECT_EQ(database.report.pairs, 10u);
  EXPECT_EQ(database.report.cuts, 0u);
  const std::string want[3][3] = {
      {"01234", "10234", "21304"}, {"12034", "21034", "32104"}, {"23140", "32140", "43210"}};
  const double at[3] = {5, 20, 30};
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      EXPECT_EQ(counts_from(database, {at[x], at[y], 100}), want[x][y])
          << "x " << at[x] << ", y " << at[y];
}

TEST(SeparationTable, StumpsCountsOfHisTableThatIsNotListable) {
  const Database database = prepare(shipped("stump-not-listable.json"));
  const PriorityHierarchy& h = database.systems[0].hierarchy;
  ASSERT_EQ(h.nodes.size(), 3u);
  const std::vector<std::vector<int>> want{{0, 0, 1, 1}, {0, 1, 2, 1}, {0, 2, 2, 2}};
  for (std::size_t planes = 1; planes <= 3; ++planes) {
    const auto counts =
        priority_processor::counters(std::span(h.nodes.data(), planes), 0, 15, h.pairs);
    EXPECT_EQ(std::vector<int>(counts.begin(), counts.begin() + 4), want[planes - 1])
        << "after plane " << planes;
  }
}

TEST(SeparationTable, StumpsCircuitIsNamed) {
  const Environment environment = shipped("stump-not-listable.json");
  const Database database = prepare(environment);
  for (const Method method : {Method::kCounters, Method::kSoMatrix}) {
    const PriorityList list = list_from(database, environment.view->eye.position, method);
    ASSERT_EQ(list.faults.size(), 1u);
    const ListabilityFault want{0, {1, 2, 3, 4}, {2, 3, 4}, {}};
    EXPECT_EQ(list.faults[0], want);
    EXPECT_EQ(list.items.size(), 4u) << "there is a list all the same";
  }
}

TEST(SeparationTable, MembersOutOfViewBreakACircuit) {
  const Database database = prepare(shipped("stump-not-listable.json"));
  const PreparedSystem& world = database.systems[0];
  ActiveEnvironment active;
  active.view.eye = {-14, -16, 14};
  active.groups.push_back({0, 0b0111, 0});
  PriorityList list;
  Functional<double>(Method::kCounters)
      .compute(world.hierarchy, world.set, active, database.ground, list);
  EXPECT_TRUE(list.faults.empty());
  const std::vector<ItemRef> want{{SetId::kStatic, 0}, {SetId::kStatic, 1}, {SetId::kStatic, 2}};
  EXPECT_EQ(list.items, want);
}

TEST(SeparationTable, APairThatNoPlaneResolvesIsNamed) {
  Environment environment =
      boxes({{{0, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {3, 1, 1}}, {{4, 0, 0}, {5, 1, 1}}});
  environment.separation = {{{1, 0, 0}, 1.5, {{2, 1}}}, {{1, 0, 0}, 3.5, {{3, 2}}}};
  const Database database = prepare(environment);
  for (const Method method : {Method::kCounters, Method::kSoMatrix}) {
    const PriorityList list = list_from(database, {-1, 0, 0}, method);
    ASSERT_EQ(list.faults.size(), 1u);
    const ListabilityFault want{0, {1, 2, 3}, {}, {{1, 3}}};
    EXPECT_EQ(list.faults[0], want);
  }
}

// Members with random sides of random planes; each pair is given to one plane that parts it.
struct RandomTable {
  PriorityHierarchy hierarchy;
  FaceSet objects;
  bool before[8][8] = {};  // from the eyepoint
  std::uint64_t eye_true = 0, active = 0;
  std::uint32_t size = 0;

  explicit RandomTable(Random& random) {
    size = 2 + random.below(7);
    active = (std::uint64_t{1} << size) - 1;
    const std::uint32_t planes = 1 + random.below(6);
    eye_true = random.bits() & ((std::uint64_t{1} << planes) - 1);
    std::vector<std::uint64_t> on_true(planes);
    for (std::uint64_t& side : on_true) side = random.bits();
    std::vector<std::vector<MemberPair>> listed(planes);
    for (std::uint8_t a = 0; a < size; ++a)
      for (std::uint8_t b = 0; b < a; ++b) {
        const std::uint32_t plane = random.below(planes);
        const bool a_true = on_true[plane] >> a & 1, b_true = on_true[plane] >> b & 1;
        if (a_true == b_true) continue;
        listed[plane].push_back(a_true ? MemberPair{a, b} : MemberPair{b, a});
        const bool eye = eye_true >> plane & 1;
        (a_true == eye ? before[a][b] : before[b][a]) = true;
      }
    std::uint64_t kept = 0;
    for (std::uint32_t p = 0; p < planes; ++p) {
      if (listed[p].empty()) continue;
      SeparationNode node;
      node.first_pair = static_cast<std::uint32_t>(hierarchy.pairs.size());
      node.pair_count = static_cast<std::uint32_t>(listed[p].size());
      for (const MemberPair& pair : listed[p]) {
        hierarchy.pairs.push_back(pair);
        node.true_members |= std::uint64_t{1} << pair.true_member;
        node.false_members |= std::uint64_t{1} << pair.false_member;
      }
      kept |= (eye_true >> p & 1) << hierarchy.nodes.size();
      hierarchy.nodes.push_back(node);
    }
    eye_true = kept;
    for (std::uint32_t m = 0; m < size; ++m) {
      hierarchy.members.push_back({false, m, {}});
      objects.items.push_back({m, 1, 0, 0, {}});
      objects.faces.push_back({0, 0, 0, 10 * (m + 1), {}, false});
    }
    hierarchy.groups.push_back({0, size, 0, static_cast<std::uint32_t>(hierarchy.nodes.size())});
  }

  // Whether exactly one order of the members agrees with all pairs, and every pair has an answer.
  bool listable() const {
    std::vector<std::uint32_t> order(size);
    for (std::uint32_t i = 0; i < size; ++i) order[i] = i;
    do {
      bool agrees = true;
      for (std::uint32_t i = 0; i < size && agrees; ++i)
        for (std::uint32_t j = i + 1; j < size && agrees; ++j) agrees = before[order[i]][order[j]];
      if (agrees) return true;
    } while (std::next_permutation(order.begin(), order.end()));
    return false;
  }

  // Length of the shortest circuit, 0 without one: walks of growing length.
  std::size_t shortest_circuit() const {
    bool walk[8][8];
    std::copy(&before[0][0], &before[0][0] + 64, &walk[0][0]);
    for (std::size_t length = 1; length <= size; ++length) {
      for (std::uint32_t m = 0; m < size; ++m)
        if (walk[m][m]) return length;
      bool longer[8][8] = {};
      for (std::uint32_t a = 0; a < size; ++a)
        for (std::uint32_t b = 0; b < size; ++b)
          for (std::uint32_t c = 0; c < size; ++c)
            longer[a][c] = longer[a][c] || (walk[a][b] && before[b][c]);
      std::copy(&longer[0][0], &longer[0][0] + 64, &walk[0][0]);
    }
    return 0;
  }
};

TEST(SeparationTable, RandomTablesAgainstBruteForce) {
  const std::uint64_t seed = 20;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int listable = 0, circuits = 0, unresolved = 0;
  for (int k = 0; k < 2000; ++k) {
    const RandomTable t(random);
    const auto& h = t.hierarchy;
    GroupOrder a, b;
    priority_processor::order_by_counters(h.nodes, t.eye_true, t.active, a, h.pairs);
    priority_processor::order_by_so_matrix(h.nodes, t.eye_true, t.active, b, h.pairs);
    ASSERT_EQ(a.unique, b.unique);
    ASSERT_TRUE(std::equal(a.member.begin(), a.member.begin() + t.size, b.member.begin()));
    ASSERT_EQ(a.unique, t.listable());
    if (a.unique) {
      ++listable;
      for (std::uint32_t i = 1; i < t.size; ++i)
        ASSERT_TRUE(t.before[a.member[i - 1]][a.member[i]]);
      continue;
    }
    const ListabilityFault fault =
        priority_processor::listability_fault(h, t.objects, 0, t.active, t.eye_true);
    ASSERT_EQ(fault.members.size(), t.size);
    ASSERT_EQ(fault.circuit.size(), t.shortest_circuit());
    circuits += !fault.circuit.empty();
    for (std::size_t i = 0; i < fault.circuit.size(); ++i)
      ASSERT_TRUE(t.before[fault.circuit[i] / 10 - 1]
                          [fault.circuit[(i + 1) % fault.circuit.size()] / 10 - 1]);
    std::size_t open = 0;
    for (std::uint32_t i = 0; i < t.size; ++i)
      for (std::uint32_t j = i + 1; j < t.size; ++j) open += !t.before[i][j] && !t.before[j][i];
    ASSERT_EQ(fault.unresolved.size(), open);
    for (const auto& [i, j] : fault.unresolved)
      ASSERT_FALSE(t.before[i / 10 - 1][j / 10 - 1] || t.before[j / 10 - 1][i / 10 - 1]);
    unresolved += open > 0;
    ASSERT_TRUE(open > 0 || !fault.circuit.empty()) << "every fault has a cause";
  }
  EXPECT_GT(listable, 50);
  EXPECT_GT(circuits, 50);
  EXPECT_GT(unresolved, 50);
}

TEST(SeparationTable, PicturesAreThoseOfThePreparationsOwnPlanes) {
  Environment third = shipped("stump-case-3.deck");
  third.separation = {{{1, 0, 0}, 25, {{5, 1}, {5, 2}, {5, 3}, {5, 4}}},
                      {{0, 1, 0}, 25, {{4, 1}, {4, 2}, {4, 3}}},
                      {{1, 0, 0}, 10, {{3, 1}, {3, 2}}},
                      {{0, 1, 0}, 10, {{2, 1}}}};
  for (Environment environment : {third, shipped("stump-not-listable.json")}) {
    const Database by_hand = prepare(environment);
    environment.separation.clear();
    const Database own = prepare(environment);
    MachineOptions options;
    options.raster = {96, 96};
    FunctionalMachine a(by_hand, options), b(own, options);
    for (const Vec3& eye : {Vec3{-40, -50, 40}, {80, -60, 20}, {70, 90, 60}, {-60, 70, 3}}) {
      const Viewpoint viewpoint{look_at(eye, own.systems[0].sphere.centre), 50};
      EXPECT_EQ(a.compute(viewpoint, 0).colours, b.compute(viewpoint, 0).colours);
      EXPECT_EQ(b.stats().faults, 0u);
    }
  }
}

std::string refusal(const Environment& environment) {
  PrepareOptions options;
  options.file = "t.json";
  try {
    prepare(environment, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const Environment& environment, const std::string& message) {
  EXPECT_EQ(refusal(environment).substr(0, message.size()), message);
}

TEST(SeparationTable, ObjectsOnTheWrongSideAreNamedWithTheirPlane) {
  Environment two = boxes({{{0, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {3, 1, 1}}});
  two.separation = {{{1, 0, 0}, 1.5, {{1, 2}}}};
  expect_refusal(two,
                 "t.json: object 1 is listed as TRUE at separation plane 1, but it lies on the "
                 "other side");
  two.separation[0].pairs = {{2, 1}};
  EXPECT_EQ(refusal(two), "");
  two.separation.push_back({{1, 0, 0}, 0.5, {{2, 1}}});
  expect_refusal(two,
                 "t.json: object 1 is listed as FALSE at separation plane 2, but the plane "
                 "cuts it");
}

TEST(SeparationTable, ATouchingPlaneAndABystanderThatItCutsAreNoFault) {
  Environment three =
      boxes({{{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}, {{0, 5, 0}, {2, 6, 1}}});
  three.separation = {{{1, 0, 0}, 1, {{2, 1}}}, {{0, 1, 0}, 3, {{3, 1}, {3, 2}}}};
  EXPECT_EQ(refusal(three), "");
}

TEST(SeparationTable, WhatCannotBeOneGroupIsRefused) {
  Environment environment = boxes({{{0, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {3, 1, 1}}});
  environment.separation = {{{1, 0, 0}, 1.5, {{2, 1}}}};
  ASSERT_EQ(refusal(environment), "");

  Environment open = environment;
  open.objects[1].faces.pop_back();
  expect_refusal(open, "t.json: object 2 is no convex body");

  Environment moving = environment;
  moving.systems.push_back({"plane", {}, {{0, {}}, {1, {}}}});
  expect_refusal(moving, "t.json: system \"plane\" moves");

  Environment many = environment;
  for (int i = 2; i < 65; ++i) many.objects.push_back(box({3.0 * i, 0, 0}, {3.0 * i + 1, 1, 1}));
  expect_refusal(many, "t.json: a separation table takes at most 64 objects, not 65");

  Environment planes = environment;
  planes.separation.assign(64, planes.separation[0]);
  expect_refusal(planes, "t.json: a separation table takes at most 63 planes, not 64");

  Environment stranger = environment;
  stranger.separation[0].pairs = {{3, 1}};
  expect_refusal(stranger, "t.json: separation plane 1 names an object that is not there");
}

TEST(SeparationTable, SixtyFourObjectsOnSixtyThreePlanesHaveAnOrder) {
  std::vector<std::pair<Vec3, Vec3>> extents;
  for (int i = 0; i < 64; ++i) extents.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
  Environment row = boxes(extents);
  for (std::uint32_t p = 1; p < 64; ++p) {
    SeparationPlane plane{{1, 0, 0}, 2.0 * p - 0.5, {}};
    for (std::uint32_t before = 1; before <= p; ++before) plane.pairs.push_back({p + 1, before});
    row.separation.push_back(plane);
  }
  const Database database = prepare(row);
  EXPECT_EQ(database.report.pairs, 64u * 63 / 2);
  const PreparedSystem& world = database.systems[0];
  ActiveEnvironment active;
  active.view.eye = {61, 0, 0};  // within the 31st
  active.groups.push_back({0, ~std::uint64_t{0}, 0});
  for (const Method method : {Method::kCounters, Method::kSoMatrix}) {
    PriorityList list;
    Functional<double>(method).compute(world.hierarchy, world.set, active, database.ground, list);
    EXPECT_TRUE(list.faults.empty());
    // Each is behind those between it and the eyepoint.
    std::array<std::size_t, 64> place{};
    for (std::size_t i = 0; i < list.items.size(); ++i) place[list.items[i].item] = i;
    for (std::size_t i = 0; i < 30; ++i) EXPECT_GT(place[i], place[i + 1]);
    for (std::size_t i = 31; i < 64; ++i) EXPECT_GT(place[i], place[i - 1]);
  }
}

}  // namespace
}  // namespace cigsim
