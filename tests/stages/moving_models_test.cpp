// SPDX-License-Identifier: MIT
// Scenes with moving systems against the oracle on the geometry as it is placed for the frame.
// Bodies have triangles only where the exact picture must agree on every element: placing rounds
// vertices, and corners of larger faces no longer lie in one plane.
#include <gtest/gtest.h>

#include "models/database/prepare.hpp"
#include "models/environment/placement.hpp"
#include "models/frame_calculator/functional.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/picture_check.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

// A world with systems besides; objects may belong to models of any system.
struct MovingWorld {
  World world;

  std::uint32_t add_system(const Placement& placement) {
    Environment& e = world.environment;
    e.systems.push_back({"moving", {}, {{0, placement}}});
    e.models.push_back({"model", static_cast<std::uint32_t>(e.systems.size() - 1)});
    return static_cast<std::uint32_t>(e.models.size() - 1);
  }
  void add(std::uint32_t model, Object object, bool open = false) {
    object.model = model;
    world.add(std::move(object), open);
  }
};

// Everything where it stands at a frame.
World placed(const World& world, const Database& database, double frame) {
  World out = world;
  std::vector<Placement> placements{{}};
  for (std::size_t s = 1; s < database.systems.size(); ++s)
    placements.push_back(frame_calculator::placement_at(database.systems[s], frame));
  for (Object& object : out.environment.objects) {
    const std::uint32_t system = out.environment.models[object.model].system;
    if (system == 0) continue;
    const Placing place(placements[system]);
    for (Vec3& v : object.vertices) v = place(v);
  }
  return out;
}

// Eyepoints in general position: at an ulp from a face's edge, an ulp of a vertex is half the view.
void check(const MovingWorld& moving, Random& random, int views, Strictness strictness,
           const std::string& what, Tally& tally) {
  const Database database = prepare(moving.world.environment);
  const World world = placed(moving.world, database, 0);
  for (int v = 0; v < views; ++v) {
    const Viewpoint viewpoint = plain_viewpoint(world.environment, random);
    check_machine(polygons_of(world), database, viewpoint, random_raster(random, 32), 0, strictness,
                  what + " view " + std::to_string(v), tally);
  }
}

Placement random_placement(Random& random, double reach) {
  return {random_direction(random) * random.between(0, reach), random.between(-180, 180),
          random.between(-90, 90), random.between(-180, 180)};
}

std::string seed_text(std::uint64_t seed) { return "seed " + std::to_string(seed); }

TEST(MovingModels, AmongStaticBodiesThatTheyMayPassThrough) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    MovingWorld m;
    m.world = body_soup(random, 1 + static_cast<int>(random.below(4)));
    for (std::uint32_t s = 0; s < 1 + random.below(2); ++s) {
      const std::uint32_t model = m.add_system(random_placement(random, 8));
      const double spread = 4;
      for (std::uint32_t i = 0; i < 1 + random.below(3); ++i)
        m.add(model, random_tetrahedron(random_direction(random) * spread, random.between(0.5, 4),
                                        random));
    }
    check(m, random, 6, Strictness::kEveryElement, seed_text(seed), tally);
  }
  check_rate(tally);
}

TEST(MovingModels, WithBoxesAgreeAwayFromEdges) {
  Tally tally;
  for (std::uint64_t seed = 100; seed < 130; ++seed) {
    Random random(seed);
    MovingWorld m;
    m.world = grid_boxes(random, 1 + static_cast<int>(random.below(4)));
    for (std::uint32_t s = 0; s < 1 + random.below(3); ++s) {
      const std::uint32_t model = m.add_system(random_placement(random, 6));
      m.add(model, random_body({2, 0, 0}, 1.5, random));
      m.add(model, box_between({-1, -1, -1}, {0.5, 1, 1}));
    }
    check(m, random, 6, Strictness::kNearEdges, seed_text(seed), tally);
  }
}

TEST(MovingModels, AmongSurfacesSeenFromBothSides) {
  Tally tally;
  for (std::uint64_t seed = 200; seed < 230; ++seed) {
    Random random(seed);
    MovingWorld m;
    m.world = triangle_soup(random, 1 + static_cast<int>(random.below(5)));
    const std::uint32_t model = m.add_system(random_placement(random, 5));
    for (int i = 0; i < 3; ++i)
      m.add(model,
            polygon({random_direction(random) * 5, random_direction(random) * 5,
                     random_direction(random) * 5}),
            true);
    m.add(model, random_tetrahedron({}, 4, random));
    check(m, random, 6, Strictness::kEveryElement, seed_text(seed), tally);
  }
  check_rate(tally);
}

TEST(MovingModels, WhoseSpheresMeet) {
  Tally tally;
  for (std::uint64_t seed = 300; seed < 308; ++seed) {
    Random random(seed);
    MovingWorld m;
    if (random.below(2)) m.world = body_soup(random, 2);
    for (int s = 0; s < 2; ++s) {
      const std::uint32_t model = m.add_system(random_placement(random, 3));
      m.add(model, random_tetrahedron({1, 0, 0}, 4, random));
      m.add(model, random_tetrahedron({-1, 0, 0}, 3, random));
    }
    check(m, random, 3, Strictness::kEveryElement, seed_text(seed), tally);
  }
  check_rate(tally);
}

TEST(MovingModels, TouchStaticFacesWithoutATurn) {
  Tally tally;
  for (std::uint64_t seed = 400; seed < 430; ++seed) {
    Random random(seed);
    MovingWorld m;
    m.world = grid_boxes(random, 1 + static_cast<int>(random.below(3)));
    const Vec3 at = m.world.environment.objects[0].vertices[random.below(8)];
    const std::uint32_t model = m.add_system({at, 90.0 * random.below(4), 0, 0});
    m.add(model, box_between({0, 0, 0}, {1.5, 2, 1}));
    m.add(model, box_between({1.5, 0, 0}, {2, 0.5, 4}));
    const Database database = prepare(m.world.environment);
    const World world = placed(m.world, database, 0);
    for (int v = 0; v < 6; ++v) {
      const Viewpoint viewpoint = random_viewpoint(world.environment, random);
      check_machine(polygons_of(world), database, viewpoint, random_raster(random, 32), 0,
                    Strictness::kEveryElement, seed_text(seed), tally);
    }
  }
  check_rate(tally);
}

TEST(MovingModels, FlyThroughAWallFrameByFrame) {
  Random random(7);
  World world;
  world.add(box_between({-0.5, -20, -20}, {0.5, 20, 20}));
  world.add(box_between({4, -20, -20}, {4.25, 20, 0}));
  Environment& e = world.environment;
  e.systems.push_back(
      {"dart", {}, {{0, {{-10, 0, 1}, 90, 0, 0}}, {20, {{10, 1, -1}, 120, 10, 45}}}});
  e.models.push_back({"dart", 1});
  Object dart = random_tetrahedron({}, 2, random);
  dart.model = 1;
  world.add(std::move(dart));
  const Database database = prepare(e);
  Tally tally;
  for (int frame = 0; frame <= 20; ++frame) {
    const World now = placed(world, database, frame);
    for (int v = 0; v < 4; ++v)
      check_machine(polygons_of(now), database, plain_viewpoint(now.environment, random), {32, 32},
                    frame, Strictness::kEveryElement, "frame " + std::to_string(frame), tally);
  }
  check_rate(tally);
}

TEST(MovingModels, FromACornerOfATurnedBoxLookingAwayShowNothing) {
  for (std::uint64_t seed = 500; seed < 520; ++seed) {
    SCOPED_TRACE(seed_text(seed));
    Random random(seed);
    MovingWorld m;
    m.add(m.add_system(random_placement(random, 5)), box_between({-1, -1, -1}, {1, 1, 1}));
    const Database database = prepare(m.world.environment);
    const World world = placed(m.world, database, 0);
    const Vec3 centre = m.world.environment.systems[1].motion[0].placement.position;
    for (const NumberType number : {NumberType::kDouble, NumberType::kExact}) {
      MachineOptions options;
      options.number = number;
      options.raster = {16, 16};
      FunctionalMachine machine(database, options);
      for (const Vec3& corner : world.environment.objects[0].vertices) {
        Viewpoint viewpoint;
        viewpoint.eye = look_at(corner, corner + (corner - centre));
        for (const std::uint16_t n : machine.compute(viewpoint, 0).numbers) ASSERT_EQ(n, 0);
      }
    }
  }
}

TEST(MovingModels, AloneInTheEnvironment) {
  Random random(11);
  MovingWorld m;
  const std::uint32_t model = m.add_system(random_placement(random, 5));
  m.add(model, random_tetrahedron({}, 2, random));
  m.add(model, random_tetrahedron({5, 0, 0}, 2, random));
  Tally tally;
  check(m, random, 20, Strictness::kEveryElement, "seed 11", tally);
}

TEST(MovingModels, AnEmptySystemIsNoHindrance) {
  Random random(12);
  MovingWorld m;
  m.add_system(random_placement(random, 5));
  const std::uint32_t model = m.add_system(random_placement(random, 5));
  m.add(model, random_tetrahedron({}, 2, random));
  m.add(0, box_between({0, 0, 0}, {1, 1, 1}));
  Tally tally;
  check(m, random, 20, Strictness::kEveryElement, "seed 12", tally);
}

}  // namespace
}  // namespace cigsim::test
