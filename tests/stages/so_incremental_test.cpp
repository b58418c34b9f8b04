// SPDX-License-Identifier: MIT
// The SO matrix kept up to date against the golden model, which works it out anew.
#include "models/priority_processor/so_incremental.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "models/environment/random.hpp"
#include "models/priority_processor/so_golden.hpp"

namespace cigsim::priority_processor {
namespace {

std::vector<SeparationNode> random_nodes(Random& random, std::uint32_t members, std::size_t count) {
  std::vector<SeparationNode> nodes(count);
  const std::uint64_t all = members == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << members) - 1;
  for (SeparationNode& node : nodes) {
    const std::uint64_t some = random.below(2) ? random.bits() & random.bits() : random.bits();
    node.true_members = random.bits() & some & all;
    node.false_members = ~random.bits() & some & all & ~node.true_members;
  }
  return nodes;
}

SoGolden golden_of(const std::vector<SeparationNode>& nodes, std::uint32_t members) {
  SoGolden golden(members, static_cast<unsigned>(nodes.size()));
  for (std::uint32_t m = 0; m < members; ++m) {
    SoRow row;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      row.plus[0] |= (nodes[n].true_members >> m & 1) << n;
      row.tells[0] |= ((nodes[n].true_members | nodes[n].false_members) >> m & 1) << n;
    }
    golden.set_row(m, row);
  }
  return golden;
}

TEST(SoIncremental, StaysTheMatrixThatIsWorkedOutAnew) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::uint32_t members = seed % 5 == 0 ? 64 : 2 + random.below(40);
    const std::size_t planes = seed % 7 == 0 ? 64 : 1 + random.below(40);
    const auto nodes = random_nodes(random, members, planes);
    SoGolden golden = golden_of(nodes, members);
    SoIncremental kept(nodes, members);
    std::uint64_t eye = random.bits();
    for (int frame = 0; frame < 30; ++frame) {
      SoUpdateWork work;
      kept.move(eye, work);
      golden.mark({eye}, {~std::uint64_t{0}});
      for (std::uint32_t m = 0; m < members; ++m) {
        ASSERT_EQ(kept.hides(m), golden.row(m).hides[0]) << "frame " << frame << " member " << m;
        ASSERT_EQ(kept.hidden(m), golden.row(m).hidden[0]) << "frame " << frame << " member " << m;
      }
      // None, one, or any number of planes is crossed.
      if (frame % 3 == 0) eye ^= std::uint64_t{1} << random.below(planes);
      if (frame % 3 == 1) eye = random.bits();
    }
  }
}

TEST(SoIncremental, CountsTheCyclesAndPairsOfACrossing) {
  SeparationNode first, second;
  first.true_members = 0b0011, first.false_members = 0b1100;
  second.true_members = 0b0001, second.false_members = 0b0010;
  const std::vector<SeparationNode> nodes{first, second};
  SoIncremental kept(nodes, 4);
  SoUpdateWork work;
  kept.move(0b00, work);
  EXPECT_EQ(work.crossings, 2u);
  EXPECT_EQ(work.pairs, 4u + 1u);
  EXPECT_EQ(work.cycles, 1u + 4u + 1u + 2u);
  EXPECT_EQ(kept.hidden(0), 0b1110u) << "all others are nearer";
  work = {};
  kept.move(0b00, work);
  EXPECT_EQ(work.cycles, 0u) << "an eye that crosses nothing costs nothing";
  kept.move(0b10, work);
  EXPECT_EQ(work.crossings, 1u);
  EXPECT_EQ(work.cycles, 3u);
  EXPECT_EQ(kept.hidden(0), 0b1100u);
  EXPECT_EQ(kept.hidden(1), 0b1101u);
}

}  // namespace
}  // namespace cigsim::priority_processor
