// SPDX-License-Identifier: MIT
// Pictures in certified numbers are those in exact numbers, in every element's colour and number:
// the scenes that ship, samples that lie exactly on edges, slivers,
// extremes of scale, field of view and raster. (Random worlds: every test that uses
// tests/support/picture_check.hpp compares them too.)
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "models/frame_calculator/functional.hpp"
#include "tests/stages/certified_pair.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/ray_oracle.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

std::filesystem::path scenes() { return std::filesystem::path(CIGSIM_SOURCE_DIR) / "scenes"; }

constexpr ResolverMethod kResolvers[] = {ResolverMethod::kPainter, ResolverMethod::kCoverage,
                                         ResolverMethod::kActiveList};

// The scene's own view, turned along the axes and in general.
std::vector<Viewpoint> views_of(const Database& database) {
  const Viewpoint own{database.view.eye, database.view.fov};
  std::vector<Viewpoint> views{own};
  Viewpoint level = own;
  level.eye.pitch = level.eye.roll = 0;
  for (Vec3 p = level.eye.position; const double heading : {0.0, 90.0, 180.0, 270.0}) {
    level.eye.position = {std::round(p.x), std::round(p.y), std::round(p.z)};
    level.eye.heading = heading;
    level.fov = 90;
    views.push_back(level);
  }
  Viewpoint wide = own, narrow = own;
  wide.fov = 175;
  narrow.fov = 0.5;
  views.push_back(wide);
  views.push_back(narrow);
  return views;
}

TEST(CertifiedPictures, OfEverySceneThatShips) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenes())) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".json" && ending != ".deck") continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++count;
    const Database database = prepare(read_environment(entry.path()).environment);
    for (const Raster& raster : {Raster{97, 73}, Raster{64, 64}}) {
      for (const ResolverMethod resolver : kResolvers) {
        Pair pair(
            database, raster, resolver,
            resolver == ResolverMethod::kActiveList && database.systems[0].hierarchy.pairs.empty()
                ? PriorityMethod::kSoMatrix
                : PriorityMethod::kCounters);
        for (const Viewpoint& view : views_of(database)) pair.check(view);
      }
    }
  }
  EXPECT_GT(count, 15);
}

TEST(CertifiedPictures, OfEveryLevelOfDetail) {
  const Database database = prepare(read_environment(scenes() / "levine-towers.json").environment);
  for (const double detail : {0.25, 1.0, 4.0}) {
    SCOPED_TRACE(detail);
    Pair pair(database, {120, 90}, ResolverMethod::kAuto, PriorityMethod::kCounters, detail);
    Viewpoint view{database.view.eye, database.view.fov};
    for (int k = 0; k < 6; ++k) {
      pair.check(view);
      view.eye.position.y += 37.5;
    }
  }
}

// Whole coordinates seen along the axes, in rasters with a sample in the middle: edges run through
// rows and columns of samples.
TEST(CertifiedPictures, OfEdgesThroughSamples) {
  World world;
  for (int i = -3; i <= 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const Vec3 at{4.0 * i, 8.0 + 6 * k, -2.0 + 2 * k};
      world.add(box_between(at, at + Vec3{2, 2, 3}));
      world.add(box_between(at * -1.0, at * -1.0 + Vec3{2, -2, 3}));
    }
  world.add(polygon({{0, 2, -9}, {0, 2, 9}, {9, 2, 0}}), true);
  const Database database = prepare(world.environment);
  for (const ResolverMethod resolver : kResolvers) {
    Pair pair(database, {65, 33}, resolver);
    Pair square(database, {33, 33}, resolver);
    for (const double heading : {0.0, 90.0, 180.0, 270.0})
      for (const double fov : {90.0, 60.0})
        for (const Vec3& eye : {Vec3{0, 0, 0}, Vec3{1, -4, 1}, Vec3{-0.5, 0, -2}}) {
          const Viewpoint view{{eye, heading, 0, 0}, fov};
          pair.check(view);
          square.check(view);
        }
    EXPECT_GT(pair.redone().vertices_redone, 0u);
    EXPECT_GT(pair.redone().crossings_redone, 0u);
    pair.tell();
  }
}

// A triangle of whole coordinates seen from the origin, of which doubles show three elements that
// the rays through their samples miss.
// Edges through a line of samples whose slope, elements a line, no double holds.
TEST(CertifiedPictures, OfEdgesThatAreLevelButForTheSmallestDoubles) {
  for (const double rise : {5e-324, 1e-320, 1e-310, 1e-305, 1e-200, 1e-20})
    for (const double turn : {1.0, -1.0})
      for (const ResolverMethod resolver : kResolvers) {
        SCOPED_TRACE(rise * turn);
        World world;
        world.add(polygon({{-100, 10, turn * rise}, {100, 10, -turn * rise}, {0, 10, 100}}), true);
        const Database database = prepare(world.environment);
        Pair pair(database, {65, 65}, resolver);
        for (const double heading : {0.0, 1e-3, 180.0})
          pair.check({{{0, 0, 0}, heading, 0, 0}, 60});
      }
}

TEST(CertifiedPictures, AreRightWhereDoublesAreWrong) {
  World world;
  world.add(polygon({{5, 10, -3}, {-8, 6, -4}, {-11, 6, 4}}), true);
  const Database database = prepare(world.environment);
  const Viewpoint viewpoint{{}, 90};
  const Raster raster{16, 16};
  const std::vector<std::uint16_t> want =
      cast_rays(polygons_of(world), frame_calculator::view_transform(viewpoint, raster));
  MachineOptions options;
  options.raster = raster;
  FunctionalMachine rounded(database, options);
  options.number = NumberType::kCertified;
  FunctionalMachine certified(database, options);
  const std::vector<std::uint16_t> wrong = rounded.compute(viewpoint, 0).numbers;
  int count = 0;
  for (std::size_t i = 0; i < want.size(); ++i) count += wrong[i] != want[i];
  EXPECT_EQ(count, 3);
  EXPECT_EQ(certified.compute(viewpoint, 0).numbers, want);
  EXPECT_GE(certified.stats().redone->crossings_redone, 3u);
}

TEST(CertifiedPictures, OfSlivers) {
  Random random(77);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    World world;
    const double thin = std::pow(10, random.between(-13, -1));
    for (int k = 0; k < 4; ++k) {
      const Vec3 a = random_direction(random) * 5.0, b = random_direction(random) * 5.0;
      world.add(polygon({a, b, b + random_direction(random) * thin}), true);
    }
    const Database database = prepare(world.environment);
    Pair pair(database, {48, 36}, ResolverMethod::kAuto);
    for (int v = 0; v < 4; ++v) pair.check(random_viewpoint(world.environment, random));
  }
}

TEST(CertifiedPictures, AtExtremesOfScaleAndOffset) {
  Random random(78);
  for (const double scale : {1e-12, 1e-6, 1.0, 1e6, 1e12})
    for (const double offset : {0.0, 1e3, 6.4e6}) {
      SCOPED_TRACE(scale);
      SCOPED_TRACE(offset);
      const Vec3 origin = Vec3{offset, -offset, offset} * scale;
      World world = disjoint_world(random, 8);
      for (Object& object : world.environment.objects)
        for (Vec3& v : object.vertices) v = v * scale + origin;
      const Database database = prepare(world.environment);
      Pair pair(database, {48, 36}, ResolverMethod::kAuto);
      for (int v = 0; v < 6; ++v) {
        const Vec3 eye = origin + random_direction(random) * (random.between(1, 100) * scale);
        const Object& object =
            world.environment.objects[random.below(world.environment.objects.size())];
        pair.check({look_at(eye, object.vertices[0]), random.between(1, 120)});
      }
    }
}

TEST(CertifiedPictures, OfTheSmallestAndTheLongestRasters) {
  const Database database = prepare(generate_environment("city", {30, 5}));
  for (const Raster& raster :
       {Raster{1, 1}, Raster{1, 2}, Raster{16384, 3}, Raster{3, 16384}, Raster{16384, 1}}) {
    SCOPED_TRACE(raster.width);
    Pair pair(database, raster, ResolverMethod::kAuto);
    pair.check({database.view.eye, database.view.fov});
  }
}

}  // namespace
}  // namespace cigsim::test
