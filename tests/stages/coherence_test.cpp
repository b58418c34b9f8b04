// SPDX-License-Identifier: MIT
// Priorities that are kept between frames against priorities worked out in every frame: the same
// lists and faults, frame by frame, on paths that stay, creep by an ulp, walk, leap, and stand in
// planes; in every number type and by both methods.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "models/boundary/certified_edges.hpp"
#include "models/database/prepare.hpp"
#include "models/environment/detail.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/priority_processor/functional.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

using priority_processor::Functional;
using priority_processor::Method;
using priority_processor::OrderingWork;

struct Tally {
  std::uint64_t frames = 0, reused = 0, ordered = 0, faults = 0, tested = 0, tested_plain = 0;
};

// One number type and method, with coherence and without.
template <class N>
class Pair {
 public:
  explicit Pair(Method method) : coherent_(method, true), plain_(method) {}

  void compare(const Database& database, const ActiveEnvironment& active, Tally& tally) {
    const PreparedSystem& system = database.systems[0];
    PriorityList kept, fresh;
    coherent_.compute(system.hierarchy, system.set, active, database.ground, kept);
    plain_.compute(system.hierarchy, system.set, active, database.ground, fresh);
    ASSERT_EQ(kept.items, fresh.items);
    ASSERT_EQ(kept.faults, fresh.faults);
    const OrderingWork work = coherent_.work(), all = plain_.work();
    ASSERT_EQ(work.ordered_groups + work.reused_groups, all.ordered_groups);
    ASSERT_EQ(all.reused_groups, 0u);
    ASSERT_LE(work.tested_planes, all.tested_planes);
    ++tally.frames;
    tally.reused += work.reused_groups;
    tally.ordered += work.ordered_groups;
    tally.faults += kept.faults.size();
    tally.tested += work.tested_planes;
    tally.tested_plain += all.tested_planes;
  }

 private:
  Functional<N> coherent_, plain_;
};

// All of them on one path.
class Pairs {
 public:
  void compare(const Database& database, const Viewpoint& viewpoint, double frame, Tally& tally) {
    ActiveEnvironment active;
    FaceSet moving;
    frame_calculator::Functional(database).compute(viewpoint, {32, 32}, frame, active, moving);
    for (std::size_t m = 0; m < 2; ++m) {
      ASSERT_NO_FATAL_FAILURE(in_double_[m].compare(database, active, tally)) << "double";
      ASSERT_NO_FATAL_FAILURE(in_float_[m].compare(database, active, tally)) << "float";
      ASSERT_NO_FATAL_FAILURE(in_exact_[m].compare(database, active, tally)) << "exact";
      ASSERT_NO_FATAL_FAILURE(certified_[m].compare(database, active, tally)) << "certified";
    }
  }

 private:
  std::array<Pair<double>, 2> in_double_{Pair<double>(Method::kCounters),
                                         Pair<double>(Method::kSoMatrix)};
  std::array<Pair<float>, 2> in_float_{Pair<float>(Method::kCounters),
                                       Pair<float>(Method::kSoMatrix)};
  std::array<Pair<Exact>, 2> in_exact_{Pair<Exact>(Method::kCounters),
                                       Pair<Exact>(Method::kSoMatrix)};
  std::array<Pair<Certified>, 2> certified_{Pair<Certified>(Method::kCounters),
                                            Pair<Certified>(Method::kSoMatrix)};
};

double next(double value, Random& random) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return random.below(3) == 0 ? value
                              : std::nextafter(value, random.below(2) ? kInfinity : -kInfinity);
}

// The next viewpoint of a path: a turn, an ulp, a step of any size, a leap to a hard one.
Viewpoint step(const Viewpoint& from, const Environment& environment, double size, Random& random) {
  Viewpoint to = from;
  Vec3& eye = to.eye.position;
  switch (random.below(8)) {
    case 0:
      to.eye.heading += random.between(-20, 20);
      break;
    case 1:
    case 2:
      eye = {next(eye.x, random), next(eye.y, random), next(eye.z, random)};
      break;
    case 3:
      to = random_viewpoint(environment, random);
      break;
    case 4: {  // back into a plane, after a step that an order may survive
      const Viewpoint hard = random_viewpoint(environment, random);
      eye = hard.eye.position +
            random_direction(random) * (size * std::pow(10, random.between(-16, -4)));
      break;
    }
    default:
      eye = eye + random_direction(random) * (size * std::pow(10, random.between(-12, 0)));
  }
  return to;
}

void walk(const Environment& environment, const Database& database, double size, unsigned frames,
          Random& random, Tally& tally) {
  Pairs pairs;
  Viewpoint viewpoint = random_viewpoint(environment, random);
  for (unsigned frame = 0; frame < frames; ++frame) {
    SCOPED_TRACE("frame " + std::to_string(frame));
    ASSERT_NO_FATAL_FAILURE(pairs.compare(database, viewpoint, frame, tally));
    viewpoint = step(viewpoint, environment, size, random);
  }
}

std::string seed_text(std::uint64_t seed) { return "seed " + std::to_string(seed); }

constexpr unsigned kFrames = 40;

TEST(Coherence, GivesTheSameListsInRandomWorlds) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= cases(24); ++seed) {
    SCOPED_TRACE(seed_text(seed));
    Random random(seed);
    const World world = seed % 6 == 0   ? disjoint_world(random, 40)
                        : seed % 6 == 1 ? touching_world(random)
                        : seed % 6 == 2 ? grid_boxes(random, 12)
                        : seed % 6 == 3 ? lattice_world(random, 10)
                        : seed % 6 == 4 ? coplanar_polygons(random, 12)
                                        : nested_world(random);
    const Database database = prepare(world.environment);
    ASSERT_NO_FATAL_FAILURE(walk(world.environment, database, 10, kFrames, random, tally));
  }
  EXPECT_GT(tally.reused, tally.ordered / 4);
  EXPECT_GT(tally.ordered, 1000u);
  EXPECT_LT(tally.tested, tally.tested_plain);
}

TEST(Coherence, GivesTheSameListsInACityOfManyGroups) {
  Tally tally;
  const Environment environment = generate_environment("city", {700, 3});
  const Database database = prepare(environment);
  ASSERT_GT(database.systems[0].hierarchy.groups.size(), 10u);
  Random random(7);
  SCOPED_TRACE(seed_text(7));
  ASSERT_NO_FATAL_FAILURE(walk(environment, database, 100, 60, random, tally));
  EXPECT_GT(tally.reused, 1000u);
  EXPECT_GT(tally.ordered, 1000u);
}

TEST(Coherence, KeepsEverythingFromAnEyeThatOnlyCreeps) {
  const Environment environment = generate_environment("city", {300, 1});
  const Database database = prepare(environment);
  Pairs pairs;
  Tally first, rest;
  Viewpoint viewpoint{look_at({-500, -700, 90}, {0, 0, 0}), 60};
  ASSERT_NO_FATAL_FAILURE(pairs.compare(database, viewpoint, 0, first));
  for (int frame = 0; frame < 20; ++frame) {
    viewpoint.eye.position.x += 1e-9;
    ASSERT_NO_FATAL_FAILURE(pairs.compare(database, viewpoint, 0, rest));
  }
  EXPECT_EQ(first.reused, 0u);
  EXPECT_EQ(rest.ordered, 0u);
  EXPECT_EQ(rest.tested, 0u) << "not even a plane is tested";
}

TEST(Coherence, SeesAnEyeThatCrossesAPlaneByOneUlp) {
  // Two boxes with the plane x = 1 between them.
  World world;
  world.add(box_between({0, 0, 0}, {1, 1, 1}));
  world.add(box_between({1, 0, 0}, {2, 1, 1}));
  const Database database = prepare(world.environment);
  Pairs pairs;
  Tally tally;
  Viewpoint viewpoint{look_at({1, -9, 0.5}, {1, 0, 0.5}), 60};
  const double below = std::nextafter(1.0, 0.0), above = std::nextafter(1.0, 2.0);
  for (const double x : {0.5, below, 1.0, above, below, above, 1.0, below, 1.5, 1.0, 1.0, 0.5}) {
    viewpoint.eye.position.x = x;
    ASSERT_NO_FATAL_FAILURE(pairs.compare(database, viewpoint, 0, tally)) << x;
  }
  EXPECT_GT(tally.ordered, 0u);
  EXPECT_GT(tally.reused, 0u) << "the frame that stays";
}

TEST(Coherence, GivesTheSameListsBesideMovingModelsAndLevelsOfDetail) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= cases(6); ++seed) {
    SCOPED_TRACE(seed_text(seed));
    Random random(seed);
    World world = seed % 2 ? disjoint_world(random, 12) : touching_world(random);
    Environment& e = world.environment;
    e.choices.push_back({"choice", 0, {}, {std::pow(10, random.between(0, 2))}});
    for (std::uint32_t o = 0; o < 2; ++o) e.objects[o].within = DescriptionRef{0, o};
    e.systems.push_back({"moving",
                         {},
                         {{0, {random_direction(random) * 9, 0, 0, 0}},
                          {40, {random_direction(random) * 9, 170, 20, 0}}}});
    e.models.push_back({"mover", static_cast<std::uint32_t>(e.systems.size() - 1)});
    Object mover = random_tetrahedron({0, 0, 0}, 4, random);
    mover.model = static_cast<std::uint32_t>(e.models.size() - 1);
    world.add(std::move(mover));
    const Database database = prepare(e);
    ASSERT_NO_FATAL_FAILURE(walk(e, database, 10, kFrames, random, tally));
  }
  EXPECT_GT(tally.reused, 0u);
}

TEST(Coherence, GivesTheSameFaultsWhereTheTableIsNotListable) {
  Tally tally;
  const Environment environment =
      read_environment(CIGSIM_SOURCE_DIR "/scenes/stump-not-listable.json").environment;
  const Database database = prepare(environment);
  Random random(5);
  SCOPED_TRACE(seed_text(5));
  ASSERT_NO_FATAL_FAILURE(walk(environment, database, 10, 300, random, tally));
  EXPECT_GT(tally.faults, 0u);
  EXPECT_GT(tally.reused, 0u);
}

// Scales at which floats, or squares of doubles, vanish or overflow.
TEST(Coherence, GivesTheSameListsAtEveryScale) {
  Tally tally;
  for (const double scale : {1e-160, 1e-42, 1e-20, 1e-9, 1e9, 1e18, 1e36, 1e100}) {
    SCOPED_TRACE(scale);
    Random random(11);
    World world = touching_world(random);
    for (Object& object : world.environment.objects)
      for (Vec3& v : object.vertices) v = v * scale;
    const Database database = prepare(world.environment);
    ASSERT_NO_FATAL_FAILURE(walk(world.environment, database, 3 * scale, kFrames, random, tally));
  }
  EXPECT_GT(tally.reused, 0u);
}

TEST(ClearanceInFloat, HoldsTheAnswerAtRandomEyepointsWithin) {
  constexpr std::uint64_t kSeed = 20261122;
  SCOPED_TRACE(seed_text(kSeed));
  Random random(kSeed);
  std::uint64_t wide = 0, asked = 0;
  for (unsigned i = 0; i < cases(4000); ++i) {
    const double size = std::pow(10, random.between(-12, 12));
    const auto point = [&](double reach) { return random_direction(random) * (size * reach); };
    const Vec3 middle = point(random.below(2) ? 1 : 1e5);
    const Plane plane = plane_through(middle + point(1), middle + point(1), middle + point(1));
    const Vec3 eye = middle + point(std::pow(10, random.between(-6, 2)));
    double clearance = -1;
    const bool answer = priority_processor::eye_on_true_side<float>(plane, eye, clearance);
    ASSERT_EQ(answer, priority_processor::eye_on_true_side<float>(plane, eye));
    ASSERT_GE(clearance, 0);
    wide += clearance > 0.1 * size;
    if (clearance == 0) continue;
    // Straight towards the plane and anywhere, up to the very end.
    const double length = std::sqrt(dot(plane.normal, plane.normal));
    for (int k = 0; k < 8; ++k) {
      Vec3 way = plane.normal * ((answer ? -1 : 1) / length);
      if (k % 2) way = random_direction(random);
      const Vec3 there = eye + way * (clearance * (k < 4 ? 1 : random.unit()) * (1 - 1e-12));
      const ExactVec moved = convert<Exact>(there) - convert<Exact>(eye);
      if (dot(moved, moved) >= Exact(clearance) * Exact(clearance)) continue;
      ++asked;
      ASSERT_EQ(priority_processor::eye_on_true_side<float>(plane, there), answer) << "case " << i;
    }
  }
  EXPECT_GT(wide, cases(4000) / 10);
  EXPECT_GT(asked, cases(4000));
}

}  // namespace
}  // namespace cigsim::test
