// SPDX-License-Identifier: MIT
// Scenes that are odd, but not wrong: each gives a picture, and the right one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/database/prepare.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/picture_check.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

Viewpoint from(const Vec3& eye, const Vec3& target, double fov = 60) {
  Viewpoint viewpoint;
  viewpoint.eye = look_at(eye, target);
  viewpoint.fov = fov;
  return viewpoint;
}

void check(const World& world, const Viewpoint& viewpoint, const std::string& what) {
  Tally tally;
  check_picture(world, prepare(world.environment), viewpoint, {32, 24}, what, tally);
}

TEST(DegenerateScenes, Nothing) {
  const World world;
  check(world, from({0, 0, 0}, {1, 0, 0}), "a model without objects");
  World empty;
  empty.environment.models.clear();
  check(empty, from({0, 0, 0}, {1, 0, 0}), "no model");
}

TEST(DegenerateScenes, AnObjectOfOneFace) {
  World world;
  world.add(polygon({{0, -1, -1}, {0, 1, -1}, {0, 0, 1}}), true);
  check(world, from({-3, 0, 0}, {0, 0, 0}), "from behind");
  check(world, from({3, 0, 0}, {0, 0, 0}), "from ahead");
  check(world, from({0, 5, 0}, {0, 0, 0}), "edge on");
}

TEST(DegenerateScenes, ObjectsWithoutAreaOrWithoutFaces) {
  World world;
  world.add(polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), true);
  world.add(Object{}, true);
  world.add(box_between({0, 0, 0}, {1, 1, 1}));
  // The oracle knows no faces without area.
  World seen = world;
  seen.environment.objects[0].faces.clear();
  const Database database = prepare(world.environment);
  Tally tally;
  check_machine(polygons_of(seen), database, from({5, 4, 3}, {0, 0, 0}), {32, 24}, 0,
                Strictness::kEveryElement, "", tally);
  World flat;
  flat.add(polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), true);
  check_machine({}, prepare(flat.environment), from({5, 4, 3}, {0, 0, 0}), {32, 24}, 0,
                Strictness::kEveryElement, "no face at all", tally);
}

TEST(DegenerateScenes, OfObjectsOnTopOfEachOtherTheFirstIsSeen) {
  Random random(21);
  for (int copies = 2; copies <= 5; ++copies) {
    World world;
    const Object body = random_hull({0, 0, 0}, 2, random);
    world.add(polygon({{-3, -3, 0}, {3, -3, 0}, {0, 4, 0}}), true);
    for (int i = 0; i < copies; ++i) world.add(body);
    Tally tally;
    check_world(world, random, 8, 32, std::to_string(copies) + " copies", tally);
  }
}

TEST(DegenerateScenes, OfCoplanarPolygonsTheFirstIsSeenFromBothSides) {
  World world;
  world.add(polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}), true);
  world.add(polygon({{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}), true);
  world.add(polygon({{-1, 0.5, 0}, {4, 0.5, 0}, {4, 1.5, 0}, {-1, 1.5, 0}}), true);
  check(world, from({1.5, 1.5, 5}, {1.5, 1.6, 0}), "from above");
  check(world, from({1.5, 1.5, -5}, {1.5, 1.6, 0}), "from below");
  MachineOptions options;
  options.raster = {1, 1};
  for (const double z : {5.0, -5.0}) {
    const Database database = prepare(world.environment);
    FunctionalMachine machine(database, options);
    Viewpoint viewpoint;
    viewpoint.eye = {{1.5, 1.25, z}, 0, z > 0 ? -90.0 : 90.0, 0};
    EXPECT_EQ(machine.compute(viewpoint, 0).numbers[0], 1);
    viewpoint.eye.position = {2.5, 1.25, z};
    EXPECT_EQ(machine.compute(viewpoint, 0).numbers[0], 2);
    viewpoint.eye.position = {2.5, 0.75, z};
    EXPECT_EQ(machine.compute(viewpoint, 0).numbers[0], 3);
  }
}

// A closed sheet is two faces back to back; whichever comes first in it, a face of another object
// in its plane is ordered against the one that is seen.
TEST(DegenerateScenes, AClosedSheetInTheFaceOfABodyComesAfterTheBodysFace) {
  for (const bool turned : {false, true}) {
    World world;
    world.add(box_between({0, 0, 0}, {4, 4, 2}));
    Object sheet = polygon({{1, 1, 2}, {6, 1, 2}, {6, 3, 2}, {1, 3, 2}});
    Face back = sheet.faces[0];
    std::reverse(back.vertices.begin(), back.vertices.end());
    sheet.faces.insert(turned ? sheet.faces.begin() : sheet.faces.end(), back);
    world.add(sheet);
    check(world, from({3, 2, 12}, {3, 2.5, 0}), turned ? "back first, above" : "above");
    check(world, from({5, 2, -9}, {4, 2.5, 0}), turned ? "back first, below" : "below");
  }
}

TEST(DegenerateScenes, TinyAndHugeBodiesInOneWorld) {
  Random random(22);
  Tally tally;
  for (int k = 0; k < 10; ++k) {
    World world;
    for (double size = 1e-9; size < 1e10; size *= 1000)
      world.add(random_body(random_direction(random) * (size * 3), size, random));
    check_world(world, random, 6, 32, "case " + std::to_string(k) + " of seed 22", tally);
  }
  check_rate(tally);
}

// A world moved and scaled. Rounding may take corners out of line: faces become those of the hull.
World transformed(const World& world, const Vec3& offset, double scale) {
  World out;
  for (const Object& object : world.environment.objects) {
    std::vector<Vec3> points;
    for (const Vec3& v : object.vertices) points.push_back(v * scale + offset);
    Object body = exact_hull(points);
    if (body.faces.size() >= 4) out.add(std::move(body));
  }
  return out;
}

TEST(DegenerateScenes, FarFromTheOrigin) {
  Random random(23);
  Tally tally;
  for (int k = 0; k < 10; ++k) {
    const World world = transformed(grid_boxes(random, 5), {1e15, -1e15, 1e14}, 1);
    check_world(world, random, 6, 32, "case " + std::to_string(k) + " of seed 23", tally);
  }
  check_rate(tally);
}

TEST(DegenerateScenes, ScalesWhoseProductsOverflowOrVanish) {
  Random random(24);
  for (const double scale : {1e-150, 1e-100, 1e100, 1e150})
    for (int k = 0; k < 3; ++k) {
      const World world = transformed(body_soup(random, 3), {}, scale);
      const Database database = prepare(world.environment);
      for (int v = 0; v < 4; ++v) {
        const Viewpoint viewpoint = plain_viewpoint(world.environment, random);
        Tally tally;
        check_picture(world, database, viewpoint, {24, 24},
                      "scale " + std::to_string(std::log10(scale)) + " case " + std::to_string(k) +
                          " of seed 24",
                      tally);
      }
    }
}

TEST(DegenerateScenes, HundredsOfObjects) {
  Random random(25);
  const World world = disjoint_world(random, 400);
  Tally tally;
  check_world(world, random, 12, 32, "seed 25", tally);
}

}  // namespace
}  // namespace cigsim::test
