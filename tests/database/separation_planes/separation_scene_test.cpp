// SPDX-License-Identifier: MIT
// Separations as scenes: they prepare, bring the same table, and are proved again.
#include "models/database/separation_planes/separation_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/database/listability/group_listability.hpp"
#include "models/database/prepare.hpp"
#include "tests/database/separation_planes/decks.hpp"

namespace cigsim::separation_planes {
namespace {

Environment scene_of(const StumpDeck& deck) {
  Environment scene;
  scene.models.push_back({"deck", 0});
  scene.objects = deck.objects;
  return scene;
}

void expect_prepared_and_proved(const Environment& scene, std::size_t planes) {
  const Database database = prepare(scene);
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  ASSERT_EQ(hierarchy.groups.size(), 1u);
  EXPECT_EQ(hierarchy.nodes.size(), planes);
  EXPECT_TRUE(listability::prove(listability::table_of_group(hierarchy, 0)).listable);
  EXPECT_EQ(listability::check_sides(hierarchy, database.systems[0].set, 0x1p-28).fault_count, 0u);
}

TEST(SeparationScene, StumpsCasesByBothRules) {
  for (int k = 1; k <= 3; ++k) {
    const StumpDeck deck = test::case_deck(k);
    const std::size_t planes = k == 3 ? 4 : static_cast<std::size_t>(k);
    expect_prepared_and_proved(with_table(scene_of(deck), PublishedProgram(deck, "case").run()),
                               planes);
    expect_prepared_and_proved(with_table(scene_of(deck), separate(deck)), planes);
  }
}

TEST(SeparationScene, PlanesOfSimpleNumbersAreExact) {
  const StumpDeck deck = test::case_deck(2);
  const Environment scene = with_table(scene_of(deck), separate(deck));
  ASSERT_EQ(scene.separation.size(), 2u);
  EXPECT_EQ(scene.separation[1].normal, (Vec3{1, 1, 0})) << "x + y = 20, not 0.7 and 14.1";
  EXPECT_EQ(scene.separation[1].distance, 20);
}

TEST(SeparationScene, PartsOfASplitObjectStandForIt) {
  const StumpDeck deck = test::ring_of_bars();
  const Environment scene = with_table(scene_of(deck), separate(deck));
  EXPECT_EQ(scene.objects.size(), 4u);
  expect_prepared_and_proved(scene, 3);
}

// Bars that a turn has rounded, with gaps: their parts have corners that no doubles hold.
TEST(SeparationScene, SlantedPartsPrepareToo) {
  StumpDeck deck = test::deck_of({{{-5, 0.125, -1}, {5, 1, -0.125}},
                                  {{-1, -5, 0.125}, {-0.125, 5, 1}},
                                  {{0.125, -1, -5}, {1, -0.125, 5}}});
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (Object& object : deck.objects)
    for (Vec3& v : object.vertices) {
      v = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
      v = {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
    }
  const SeparationResult result = separate(deck);
  ASSERT_FALSE(result.splits.empty());
  EXPECT_TRUE(result.proof.listable);
  expect_prepared_and_proved(with_table(scene_of(deck), result), result.planes.size());
}

}  // namespace
}  // namespace cigsim::separation_planes
