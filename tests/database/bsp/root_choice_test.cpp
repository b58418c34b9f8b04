// SPDX-License-Identifier: MIT
// The two published rules beside their definitions, taken literally in rational arithmetic.
#include "models/database/bsp/root_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "models/database/bsp/build.hpp"
#include "models/database/bsp/conflicts.hpp"
#include "models/environment/generate.hpp"
#include "tests/database/bsp/exact_polygon.hpp"

namespace cigsim {
namespace {

using test::exact_loop;
using test::side_of_loop;

struct Case {
  BspPolygons polygons;
  std::vector<std::uint32_t> items;
  std::vector<std::vector<int>> where;  // [plane's polygon][polygon]
};

Case random_case(std::uint64_t seed) {
  Case c;
  c.polygons = bsp_polygons(generate_environment("soup", {12, seed}));
  c.items.resize(c.polygons.set.items.size());
  std::iota(c.items.begin(), c.items.end(), 0);
  for (const std::uint32_t p : c.items) {
    std::vector<int>& row = c.where.emplace_back();
    for (const std::uint32_t q : c.items)
      row.push_back(side_of_loop(c.polygons.set.planes[p], exact_loop(c.polygons.set, q)));
  }
  return c;
}

// I(m, n) of root p, m and n as sides.
std::uint64_t conflicts(const Case& c, std::uint32_t p, int m, int n) {
  std::uint64_t sum = 0;
  for (const std::uint32_t s : c.items)
    for (const std::uint32_t t : c.items)
      if (c.where[p][s] == m && c.where[p][t] == n) sum += c.where[s][t] == 2;
  return sum;
}

TEST(Rule1, TakesAPlaneThatSplitsTheFewest) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    Case c = random_case(seed);
    const auto splits = [&](std::uint32_t p) {
      return std::count(c.where[p].begin(), c.where[p].end(), 2);
    };
    RootOptions options;
    options.rule = BspRule::kFewestSplits;
    const std::uint32_t root = RootChooser(c.polygons.set, options).choose(c.items);
    for (const std::uint32_t p : c.items) EXPECT_LE(splits(root), splits(p));
  }
}

TEST(Rule2, ConflictsAreThoseOfTheDefinition) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    Case c = random_case(seed);
    const std::vector<ConflictCounts> counts = count_conflicts(c.polygons.set, c.items);
    for (const std::uint32_t p : c.items) {
      EXPECT_EQ(counts[p].front_back, conflicts(c, p, 1, -1));
      EXPECT_EQ(counts[p].back_front, conflicts(c, p, -1, 1));
      EXPECT_EQ(counts[p].split_split, conflicts(c, p, 2, 2));
    }
  }
}

TEST(Rule2, TakesTheLargestValueUnderTheWeight) {
  for (const double weight : {0.0, 0.5, 1.0, 8.0}) {
    Case c = random_case(11);
    const std::vector<ConflictCounts> counts = count_conflicts(c.polygons.set, c.items);
    RootOptions options;
    options.rule = BspRule::kConflicts;
    options.weight = weight;
    const std::uint32_t root = RootChooser(c.polygons.set, options).choose(c.items);
    for (const ConflictCounts& other : counts)
      EXPECT_GE(counts[root].value(weight), other.value(weight)) << weight;
  }
}

TEST(Rule2, MoreThan64PolygonsFillSeveralWords) {
  Case c;
  c.polygons = bsp_polygons(generate_environment("soup", {60, 2}));
  c.items.resize(c.polygons.set.items.size());
  std::iota(c.items.begin(), c.items.end(), 0);
  ASSERT_GT(c.items.size(), 100u);
  const std::vector<ConflictCounts> all = count_conflicts(c.polygons.set, c.items);
  std::vector<std::uint32_t> reversed(c.items.rbegin(), c.items.rend());
  const std::vector<ConflictCounts> other = count_conflicts(c.polygons.set, reversed);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].front_back, other[all.size() - 1 - i].front_back);
    EXPECT_EQ(all[i].split_split, other[all.size() - 1 - i].split_split);
  }
}

TEST(RuleCost, IsNotWorseThanLeastSplitsOfFiveCandidates) {
  // The sum over several scenes; single ones vary with the seed of the draws.
  for (const char* kind : {"city", "random", "brushes", "soup"}) {
    std::size_t cost = 0, five = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const BspPolygons input = bsp_polygons(generate_environment(kind, {120, seed}));
      BspOptions options;
      cost += build_bsp(input, options).members.size();
      options.root.rule = BspRule::kFewestSplits;
      options.root.candidates = 5;
      five += build_bsp(input, options).members.size();
    }
    EXPECT_LT(cost, five) << kind;
  }
}

}  // namespace
}  // namespace cigsim
