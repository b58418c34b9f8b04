// SPDX-License-Identifier: MIT
// The proof of listability against Stump's example, brute force over all cells by elimination, and
// eyepoints at random.
#include "models/database/listability/listability.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/environment/random.hpp"
#include "models/priority_processor/counters.hpp"
#include "tests/database/listability/half_spaces.hpp"

namespace cigsim::listability {
namespace {

constexpr std::uint32_t A = 0, B = 1, C = 2, D = 3;

Plane plane(double nx, double ny, double nz, double d) {
  // The point of the plane at distance d along its normal, for normals of simple length.
  const Vec3 n{nx, ny, nz};
  return plane_with_normal(n * (d / dot(n, n)), n);
}

// Fig. 7: the pairs as he lists them first.
std::vector<TablePair> first_pairs() {
  return {{0, C, B}, {0, D, A}, {1, B, D}, {1, C, A}, {2, B, A}, {2, D, C}};
}
// The pairs as he assigns them anew.
std::vector<TablePair> reassigned_pairs() {
  return {{0, C, A}, {0, C, B}, {1, D, A}, {1, D, B}, {2, B, A}, {2, D, C}};
}
std::vector<Plane> three_walls() {
  return {plane(1, 0, 0, 0), plane(0, 1, 0, 0), plane(0, 0, -1, 0)};
}

TEST(Stump, Fig7IsNotListable) {
  const Proof proof = prove({4, three_walls(), first_pairs()});
  EXPECT_FALSE(proof.listable);
  EXPECT_TRUE(proof.pair_faults.empty());
  ASSERT_FALSE(proof.circuits.empty());
  const Circuit& circuit = proof.circuits.front();
  EXPECT_EQ(circuit.members, (std::array<std::uint32_t, 3>{B, C, D}));
  for (const EyeSide& s : circuit.sides) EXPECT_FALSE(s.eye_true) << "FALSE on all three planes";
  ASSERT_TRUE(circuit.eye.rounded);
  ASSERT_TRUE(proof.witness);
  EXPECT_EQ(proof.witness->counts, (std::vector<std::uint32_t>{0, 2, 2, 2}));
  EXPECT_EQ(*proof.witness->eye.rounded, *circuit.eye.rounded);
}

TEST(Stump, Fig7ReassignedFromHisViewpoint) {
  const PriorityTable table{4, three_walls(), reassigned_pairs()};
  EXPECT_EQ(counts_at(table, {-1, -1, 1}), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

// Plane 2 between planes 1 and 3, all through one line: no eyepoint is on one side of both and on
// the other of it.
TEST(Stump, Fig7ReassignedIsProvedWherePlanesShareALine) {
  const Proof proof =
      prove({4, {plane(1, 0, 0, 0), plane(1, 1, 0, 0), plane(0, 1, 0, 0)}, reassigned_pairs()});
  EXPECT_TRUE(proof.listable);
  EXPECT_TRUE(proof.listable_with_all);
  EXPECT_EQ(proof.triples, 4u);
  EXPECT_EQ(proof.circuit_count, 0u);
}

// He looks from one viewpoint only; from others the planes of Fig. 7 make a circuit of A, C, D and
// one of B, C, D unless they depend on each other as above.
TEST(Stump, Fig7ReassignedIsNotListableWherePlanesAreIndependent) {
  const Proof proof = prove({4, three_walls(), reassigned_pairs()});
  EXPECT_FALSE(proof.listable);
  EXPECT_EQ(proof.circuit_count, 4u) << "each in both senses";
  ASSERT_TRUE(proof.witness);
  EXPECT_FALSE(is_permutation(proof.witness->counts));
}

// What his program makes of the tags of Fig. 7.
TEST(Stump, Fig7DividedIsProved) {
  const Proof proof =
      prove({4, three_walls(), {{0, C, A}, {0, C, B}, {0, D, A}, {0, D, B}, {1, B, A}, {1, C, D}}});
  EXPECT_TRUE(proof.listable);
}

TEST(Listability, NothingAndOneObjectAreListable) {
  EXPECT_TRUE(prove({0, {}, {}}).listable);
  EXPECT_TRUE(prove({1, {}, {}}).listable);
}

TEST(Listability, APairWithoutPlaneFailsFromEveryEyepoint) {
  const Proof proof = prove({3, {plane(1, 0, 0, 0)}, {{0, 0, 1}, {0, 0, 2}}});
  EXPECT_FALSE(proof.listable);
  EXPECT_FALSE(proof.listable_with_all);
  EXPECT_EQ(proof.pair_faults, (std::vector<PairFault>{{1, 2, 0}}));
  ASSERT_TRUE(proof.witness);
  EXPECT_FALSE(is_permutation(proof.witness->counts));
}

// Planes x = 10 and x = 20 between three objects, A beyond 20, C before 10. A/B stands twice at 20
// and A/C nowhere: the counts are right from everywhere as long as all three are in view.
TEST(Listability, APairTwiceForAnotherCanBeRightWithAllInView) {
  const Proof proof =
      prove({3, {plane(1, 0, 0, 10), plane(1, 0, 0, 20)}, {{1, A, B}, {1, A, B}, {0, B, C}}});
  EXPECT_FALSE(proof.listable);
  EXPECT_EQ(proof.pair_faults, (std::vector<PairFault>{{A, B, 2}, {A, C, 0}}));
  EXPECT_TRUE(proof.listable_with_all);
  EXPECT_EQ(proof.cells, 3u);
  EXPECT_FALSE(proof.witness);
}

TEST(Listability, APairTwiceForAnotherFailsBetweenCrossingPlanes) {
  const Proof proof =
      prove({3, {plane(0, 1, 0, 10), plane(1, 0, 0, 20)}, {{1, A, B}, {1, A, B}, {0, B, C}}});
  EXPECT_FALSE(proof.listable_with_all);
  ASSERT_TRUE(proof.witness);
  ASSERT_TRUE(proof.witness->eye.rounded);
  EXPECT_EQ(proof.witness->counts, (std::vector<std::uint32_t>{0, 3, 0}));
}

TEST(Listability, BadPairsAreRefused) {
  EXPECT_THROW(prove({2, {plane(1, 0, 0, 0)}, {{0, 1, 1}}}), std::invalid_argument);
  EXPECT_THROW(prove({2, {plane(1, 0, 0, 0)}, {{1, 0, 1}}}), std::invalid_argument);
  EXPECT_THROW(prove({2, {plane(1, 0, 0, 0)}, {{0, 0, 2}}}), std::invalid_argument);
}

TEST(Listability, ManyCircuitsAreCountedAndTheFirstGetEyepoints) {
  // 12 members whose pairs go to planes at random: nearly every triple has circuits.
  Random random(3);
  PriorityTable table;
  table.members = 12;
  for (int p = 0; p < 20; ++p)
    table.planes.push_back(
        plane_with_normal({random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)},
                          {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}));
  for (std::uint32_t a = 0; a < 12; ++a)
    for (std::uint32_t b = 0; b < a; ++b) table.pairs.push_back({random.below(20), a, b});
  const Proof proof = prove(table);
  EXPECT_GT(proof.circuit_count, 100u);
  ASSERT_EQ(proof.circuits.size(), 8u);
  for (const Circuit& circuit : proof.circuits) {
    ASSERT_TRUE(circuit.eye.rounded);
    for (const EyeSide& s : circuit.sides)
      EXPECT_EQ(eye_is_true(table.planes[s.plane], *circuit.eye.rounded), s.eye_true);
  }
}

// A table at random: planes that often coincide, run parallel or share lines; each pair on one
// plane, or, where `careless`, some on two or none.
PriorityTable random_table(Random& random, bool careless) {
  PriorityTable table;
  table.members = 2 + random.below(4);
  const std::uint32_t planes = 1 + random.below(5);
  const bool flat = random.below(2) == 0;
  while (table.planes.size() < planes) {
    const auto small = [&] { return static_cast<double>(random.below(3)) - 1; };
    const Vec3 n{small(), small(), flat ? 0 : small()};
    if (!(n == Vec3{})) table.planes.push_back(plane_with_normal({small(), small(), small()}, n));
  }
  for (std::uint32_t a = 0; a < table.members; ++a)
    for (std::uint32_t b = 0; b < a; ++b) {
      const bool turn = random.below(3) == 0;
      table.pairs.push_back({random.below(planes), turn ? a : b, turn ? b : a});
    }
  if (careless)
    for (int k = 0; k < 2 && !table.pairs.empty(); ++k) {
      const std::size_t from = random.below(table.pairs.size()),
                        to = random.below(table.pairs.size());
      table.pairs[to] = {random.below(planes), table.pairs[from].true_member,
                         table.pairs[from].false_member};
    }
  return table;
}

// Counts by the machine's own counters.
std::vector<std::uint32_t> machine_counts(const PriorityTable& table, std::uint64_t eye_true) {
  std::vector<SeparationNode> nodes;
  std::vector<MemberPair> pairs;
  std::uint64_t sides = 0;
  for (std::uint32_t p = 0; p < table.planes.size(); ++p) {
    SeparationNode node;
    node.first_pair = static_cast<std::uint32_t>(pairs.size());
    for (const auto& [plane, t, f] : table.pairs)
      if (plane == p) pairs.push_back({static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(f)});
    node.pair_count = static_cast<std::uint32_t>(pairs.size()) - node.first_pair;
    if (node.pair_count == 0) continue;
    sides |= (eye_true >> p & 1) << nodes.size();
    nodes.push_back(node);
  }
  const std::uint64_t all = (std::uint64_t{1} << table.members) - 1;
  const auto counts = priority_processor::counters(nodes, sides, all, pairs);
  return {counts.begin(), counts.begin() + table.members};
}

// All combinations of sides, each asked of elimination whether an eyepoint has it.
bool listable_by_brute_force(const PriorityTable& table) {
  for (std::uint64_t mask = 0; mask < std::uint64_t{1} << table.planes.size(); ++mask) {
    std::vector<test::HalfSpace> spaces;
    for (std::size_t p = 0; p < table.planes.size(); ++p)
      spaces.push_back(test::half_space(table.planes[p], (mask >> p & 1) != 0));
    if (!is_permutation(machine_counts(table, mask)) && test::have_common_point(std::move(spaces)))
      return false;
  }
  return true;
}

std::uint64_t sides_at(const PriorityTable& table, const Vec3& eye) {
  std::uint64_t eye_true = 0;
  for (std::size_t p = 0; p < table.planes.size(); ++p)
    eye_true |= std::uint64_t{eye_is_true(table.planes[p], eye)} << p;
  return eye_true;
}

void check_against_brute_force(std::uint64_t seed, bool careless, int cases) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int listable = 0, not_listable = 0;
  for (int k = 0; k < cases; ++k) {
    const PriorityTable table = random_table(random, careless);
    const Proof proof = prove(table);
    const bool want = listable_by_brute_force(table);
    ASSERT_EQ(proof.listable_with_all, want) << "case " << k;
    ASSERT_EQ(proof.listable, want && proof.pair_faults.empty()) << "case " << k;
    ++(want ? listable : not_listable);
    ASSERT_EQ(proof.witness.has_value(), !want);
    if (want || !proof.witness->eye.rounded) continue;
    const Vec3& eye = *proof.witness->eye.rounded;
    ASSERT_EQ(machine_counts(table, sides_at(table, eye)), proof.witness->counts);
    ASSERT_FALSE(is_permutation(proof.witness->counts));
  }
  EXPECT_GT(listable, cases / 100);
  EXPECT_GT(not_listable, cases / 10);
}

TEST(Listability, RandomTablesAgainstBruteForce) { check_against_brute_force(11, false, 1500); }

TEST(Listability, RandomTablesWithPairsTwiceAgainstBruteForce) {
  check_against_brute_force(12, true, 1500);
}

TEST(Listability, EyepointsAtRandomAgreeWithTheProof) {
  const std::uint64_t seed = 13;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int k = 0; k < 300; ++k) {
    const PriorityTable table = random_table(random, false);
    if (!prove(table).listable) continue;
    for (int e = 0; e < 200; ++e) {
      // Halves hit planes, their lines and corners often.
      const auto at = [&] { return (static_cast<double>(random.below(17)) - 8) / 2; };
      const Vec3 eye{at(), at(), at()};
      ASSERT_TRUE(is_permutation(machine_counts(table, sides_at(table, eye))));
    }
  }
}

}  // namespace
}  // namespace cigsim::listability
