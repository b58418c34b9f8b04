// SPDX-License-Identifier: MIT
// The pictures of everything taken through the machine against those of what spheres against the
// pyramid of vision leave of it.
#include <gtest/gtest.h>

#include <cmath>

#include "models/database/prepare.hpp"
#include "models/environment/detail.hpp"
#include "models/environment/generate.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

struct Tally {
  std::uint64_t left_out = 0;  ///< items
};

void compare(const Database& database, const MachineOptions& options,
             const std::vector<Viewpoint>& views, Tally& tally) {
  MachineOptions all = options;
  all.retrieval = false;
  FunctionalMachine with(database, options), without(database, all);
  for (std::size_t v = 0; v < views.size(); ++v) {
    const Picture& some = with.compute(views[v], static_cast<double>(v));
    const Picture& everything = without.compute(views[v], static_cast<double>(v));
    ASSERT_EQ(some.colours, everything.colours) << "view " << v;
    ASSERT_EQ(some.numbers, everything.numbers) << "view " << v;
    const FrameStats &a = with.stats(), &b = without.stats();
    ASSERT_LE(a.active_items, b.active_items);
    ASSERT_EQ(a.faults, 0u);
    ASSERT_EQ(b.faults, 0u);
    tally.left_out += b.active_items - a.active_items;
  }
}

void compare_all(const Environment& environment, const Database& database, unsigned views,
                 Random& random, Tally& tally) {
  std::vector<Viewpoint> viewpoints;
  for (unsigned v = 0; v < views; ++v) viewpoints.push_back(random_viewpoint(environment, random));
  for (const NumberType number : {NumberType::kDouble, NumberType::kFloat, NumberType::kExact}) {
    SCOPED_TRACE(static_cast<int>(number));
    MachineOptions options;
    options.number = number;
    options.raster = random_raster(random, 48);
    ASSERT_NO_FATAL_FAILURE(compare(database, options, viewpoints, tally));
  }
}

std::string seed_text(std::uint64_t seed) { return "seed " + std::to_string(seed); }

TEST(Retrieval, LeavesTheSamePictureInRandomWorlds) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= cases(12); ++seed) {
    SCOPED_TRACE(seed_text(seed));
    Random random(seed);
    const World world = seed % 3 == 0   ? disjoint_world(random, 20)
                        : seed % 3 == 1 ? touching_world(random)
                                        : cell_bodies(random, 3);
    const Database database = prepare(world.environment);
    ASSERT_NO_FATAL_FAILURE(compare_all(world.environment, database, 6, random, tally));
  }
  EXPECT_GT(tally.left_out, 100u);
}

TEST(Retrieval, LeavesTheSamePictureOfACity) {
  Tally tally;
  const Environment environment = generate_environment("city", {400, 2});
  Random random(3);
  SCOPED_TRACE(seed_text(3));
  ASSERT_NO_FATAL_FAILURE(compare_all(environment, prepare(environment), 12, random, tally));
  EXPECT_GT(tally.left_out, 1000u);
}

TEST(Retrieval, LeavesTheSamePictureBesideMovingModelsAndLevelsOfDetail) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= cases(6); ++seed) {
    SCOPED_TRACE(seed_text(seed));
    Random random(seed);
    World world = disjoint_world(random, 12);
    Environment& e = world.environment;
    e.choices.push_back({"choice", 0, {}, {std::pow(10, random.between(0, 2))}});
    for (std::uint32_t o = 0; o < 2; ++o) e.objects[o].within = DescriptionRef{0, o};
    e.systems.push_back(
        {"moving", {}, {{0, {{-9, 3, 0}, 0, 0, 0}}, {6, {{9, -3, 2}, 170, 20, 0}}}});
    e.models.push_back({"mover", static_cast<std::uint32_t>(e.systems.size() - 1)});
    Object mover = random_tetrahedron({0, 0, 0}, 4, random);
    mover.model = static_cast<std::uint32_t>(e.models.size() - 1);
    world.add(std::move(mover));
    ASSERT_NO_FATAL_FAILURE(compare_all(e, prepare(e), 6, random, tally));
  }
  EXPECT_GT(tally.left_out, 0u);
}

}  // namespace
}  // namespace cigsim::test
