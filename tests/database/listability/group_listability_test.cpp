// SPDX-License-Identifier: MIT
// Proofs of prepared databases: every group listable, every item on its side.
#include "models/database/listability/group_listability.hpp"

#include <gtest/gtest.h>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::listability {
namespace {

void expect_proved(const Database& database, double tolerance) {
  for (const PreparedSystem& system : database.systems) {
    for (std::uint32_t g = 0; g < system.hierarchy.groups.size(); ++g) {
      const PriorityTable table = table_of_group(system.hierarchy, g);
      EXPECT_EQ(table.pairs.size(), std::size_t{table.members} * (table.members - 1) / 2);
      EXPECT_TRUE(prove(table).listable);
    }
    EXPECT_EQ(check_sides(system.hierarchy, system.set, tolerance).fault_count, 0u);
  }
}

TEST(GroupListability, WhatIsPreparedIsProved) {
  GenerateOptions options;
  options.objects = 150;
  for (const GenerateKind& kind : generate_kinds()) {
    SCOPED_TRACE(kind.name);
    expect_proved(prepare(generate_environment(kind.name, options)), 0x1p-28);
  }
}

TEST(GroupListability, WorldsThatAreCutAreProvedWithoutTolerance) {
  const std::uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  PrepareOptions exactly;
  exactly.contact_tolerance = 0;
  for (int k = 0; k < 4; ++k) {
    expect_proved(prepare(test::body_soup(random, 6).environment, exactly), 0);
    expect_proved(prepare(test::grid_boxes(random, 8).environment, exactly), 0);
    expect_proved(prepare(test::triangle_soup(random, 12).environment, exactly), 0);
  }
}

TEST(GroupListability, StumpsTableThatIsNotListable) {
  const Database database =
      prepare(read_environment(CIGSIM_SOURCE_DIR "/scenes/stump-not-listable.json").environment);
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  const Proof proof = prove(table_of_group(hierarchy, 0));
  EXPECT_FALSE(proof.listable);
  ASSERT_FALSE(proof.circuits.empty());
  EXPECT_EQ(proof.circuits[0].members, (std::array<std::uint32_t, 3>{1, 2, 3})) << "B, C, D";
  EXPECT_EQ(check_sides(hierarchy, database.systems[0].set, 0).fault_count, 0u);
}

TEST(GroupListability, AnItemOnTheWrongSideIsFound) {
  GenerateOptions options;
  options.objects = 40;
  Database database = prepare(generate_environment("city", options));
  PreparedSystem& system = database.systems[0];
  ASSERT_EQ(check_sides(system.hierarchy, system.set, 0x1p-28).fault_count, 0u);
  system.hierarchy.planes[0] = reversed(system.hierarchy.planes[0]);
  const SideCheck check = check_sides(system.hierarchy, system.set, 0x1p-28, 3);
  EXPECT_GE(check.fault_count, 40u) << "all that the root parts";
  ASSERT_EQ(check.faults.size(), 3u);
  EXPECT_GT(check.faults[0].depth, 0);
}

}  // namespace
}  // namespace cigsim::listability
