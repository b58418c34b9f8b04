// SPDX-License-Identifier: MIT
// The painter keeps its picture from frame to frame and lays the background only where it must.
// Along a path its pictures equal those of the coverage mask, element for element, in colour and
// number.
#include <gtest/gtest.h>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "sim/functional_machine.hpp"

namespace cigsim {
namespace {

FunctionalMachine machine(const Database& database, ResolverMethod method, Raster raster) {
  MachineOptions options;
  options.resolver = method;
  options.raster = raster;
  return FunctionalMachine(database, options);
}

// Flies `frames` frames and returns how often the automatic choice painted.
int compare_along(const Database& database, const std::vector<Viewpoint>& path, Raster raster) {
  FunctionalMachine coverage = machine(database, ResolverMethod::kCoverage, raster);
  FunctionalMachine painter = machine(database, ResolverMethod::kPainter, raster);
  FunctionalMachine automatic = machine(database, ResolverMethod::kAuto, raster);
  int painted = 0;
  for (std::size_t f = 0; f < path.size(); ++f) {
    const Picture& expected = coverage.compute(path[f], static_cast<double>(f));
    for (FunctionalMachine* other : {&painter, &automatic}) {
      const Picture& got = other->compute(path[f], static_cast<double>(f));
      EXPECT_EQ(got.numbers, expected.numbers) << "frame " << f;
      EXPECT_EQ(got.colours, expected.colours) << "frame " << f;
      EXPECT_EQ(other->stats().spans, coverage.stats().spans) << "frame " << f;
    }
    painted += automatic.stats().stages.priority_resolver == 0;
  }
  return painted;
}

TEST(Painter, FollowsACityOnAWindingPath) {
  const Database database = prepare(generate_environment("city", {60, 3}));
  std::vector<Viewpoint> path;
  for (int f = 0; f < 40; ++f) {
    Viewpoint v{database.view.eye, database.view.fov};
    v.eye.heading += 25.0 * (f % 7);
    v.eye.pitch += 6.0 * (f % 5) - 12;
    v.eye.roll = 40.0 * (f % 3);
    path.push_back(v);
  }
  compare_along(database, path, {301, 203});
}

// Big plates one behind the other: near, they cover the picture many times over; far, hardly.
TEST(Painter, TakesTurnsWithTheCoverageMask) {
  Environment environment;
  environment.models.push_back({"plates", 0});
  for (int i = 0; i < 12; ++i) {
    Object plate;
    const double y = 2 * i;
    plate.vertices = {{-9.0 - i, y, -9}, {9.0 + i, y, -9}, {9.0 + i, y, 9.0 + i}, {-9.0 - i, y, 9}};
    plate.faces.push_back({{0, 1, 2, 3}, Colour{static_cast<std::uint8_t>(20 * i), 90, 200}});
    environment.objects.push_back(plate);
  }
  const Database database = prepare(environment);
  std::vector<Viewpoint> path;
  for (const double back : {400.0, 6.0, 300.0, 5.0, 4.0, 900.0, 120.0, 8.0, 60.0})
    path.push_back({{{1.5, -back, 0.5}, 0, 0, 0}, 60});
  const int painted = compare_along(database, path, {160, 120});
  EXPECT_GT(painted, 2) << "the far views must be painted";
  EXPECT_LT(painted, static_cast<int>(path.size()) - 2) << "the near views must be resolved";
}

TEST(Painter, FliesTheApproachWithMovingModels) {
  const Database database =
      prepare(read_environment(CIGSIM_SOURCE_DIR "/scenes/airfield.json").environment);
  std::vector<Viewpoint> path;
  for (int f = 0; f < 30; ++f) {
    Viewpoint v{database.view.eye, database.view.fov};
    v.eye.position.y += 20.0 * f;
    v.eye.position.z -= 0.5 * f;
    path.push_back(v);
  }
  compare_along(database, path, {320, 240});
}

}  // namespace
}  // namespace cigsim
