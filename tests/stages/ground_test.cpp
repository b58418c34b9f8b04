// SPDX-License-Identifier: MIT
// Ground faces: behind every object, later over earlier, seen from both sides.
#include <gtest/gtest.h>

#include <algorithm>

#include "models/database/prepare.hpp"
#include "models/frame_calculator/functional.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/picture_check.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

void add_ground(World& world, Random& random, int faces) {
  for (int g = 0; g < faces; ++g) {
    // Most at level 0, where they overlap; some above others.
    const double level = random.below(3) == 0 ? random.below(3) : 0;
    const double x = random.below(33) - 16.0, y = random.below(33) - 16.0;
    const double w = 1 + random.below(16), h = 1 + random.below(16), slant = random.below(4);
    GroundFace face;
    face.vertices = {
        {x, y, level}, {x + w, y, level}, {x + w + slant, y + h, level}, {x + slant, y + h, level}};
    if (random.below(2)) std::reverse(face.vertices.begin(), face.vertices.end());
    world.environment.ground.push_back(face);
  }
}

std::vector<std::uint16_t> picture_with_ground(const World& world, const ViewTransform& view) {
  std::vector<std::uint16_t> picture = cast_rays(polygons_of(world), view);
  for (std::size_t g = world.environment.ground.size(); g-- > 0;) {
    OraclePolygon face;
    face.vertices = world.environment.ground[g].vertices;
    face.object = static_cast<std::uint32_t>(world.environment.objects.size() + g + 1);
    face.two_sided = true;
    const std::vector<std::uint16_t> layer = cast_rays({face}, view);
    for (std::size_t i = 0; i < picture.size(); ++i)
      if (picture[i] == 0) picture[i] = layer[i];
  }
  return picture;
}

TEST(Ground, LiesBehindEveryObjectInItsOwnOrder) {
  std::uint64_t ground_elements = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    World world = random.below(2) ? grid_boxes(random, 4) : body_soup(random, 3);
    add_ground(world, random, 1 + static_cast<int>(random.below(8)));
    const Database database = prepare(world.environment);
    for (int v = 0; v < 8; ++v) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " view " + std::to_string(v));
      Viewpoint viewpoint = random_viewpoint(world.environment, random);
      if (v == 0) viewpoint.eye.position.z = 0;  // level with the ground
      if (v == 1) viewpoint.eye = {{0.5, 0.25, 3}, 0, -90, 0};
      if (v == 2) viewpoint.eye = {{0.5, 0.25, -3}, 0, 90, 0};
      for (const ResolverMethod resolver :
           {ResolverMethod::kCoverage, ResolverMethod::kActiveList}) {
        MachineOptions options;
        options.number = NumberType::kExact;
        options.resolver = resolver;
        options.raster = {32, 24};
        FunctionalMachine machine(database, options);
        const std::vector<std::uint16_t> want =
            picture_with_ground(world, frame_calculator::view_transform(viewpoint, options.raster));
        ASSERT_EQ(machine.compute(viewpoint, 0).numbers, want);
        for (const std::uint16_t n : want) ground_elements += n > world.environment.objects.size();
      }
    }
  }
  EXPECT_GT(ground_elements, 10000u);
}

TEST(Ground, AloneMakesAPicture) {
  World world;
  world.environment.models.clear();
  Random random(5);
  add_ground(world, random, 5);
  const Database database = prepare(world.environment);
  MachineOptions options;
  options.number = NumberType::kExact;
  options.raster = {32, 24};
  FunctionalMachine machine(database, options);
  Viewpoint viewpoint;
  viewpoint.eye = {{0, -20, 10}, 0, -30, 0};
  EXPECT_EQ(
      machine.compute(viewpoint, 0).numbers,
      picture_with_ground(world, frame_calculator::view_transform(viewpoint, options.raster)));
}

}  // namespace
}  // namespace cigsim::test
