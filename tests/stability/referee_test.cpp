// SPDX-License-Identifier: MIT
// The referees of the decisions, against oracles of other making.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/stability/exact_sphere.hpp"
#include "sim/stability/judging.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"
#include "tests/support/ray_oracle.hpp"

namespace cigsim::stability {
namespace {

// Every element of the raster by tests/support's ray casting.
TEST(Sight, CoversTheElementsWhoseRaysHit) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    Extremes extremes;
    extremes.raster = {12, 9};
    extremes.fov = random.between(20, 150);
    extremes.distance = random.between(0.2, 2);
    if (seed % 3 == 0) extremes.aspect = 1e-3;
    const Triangle t = triangle_of({}, extremes, random);
    const ViewTransform view =
        view_towards(eyepoint_for({}, t, extremes, random), point_of(t, random), extremes, random);
    const Sight sight(t, view);
    const auto hits = test::cast_rays({{{t[0], t[1], t[2]}, 1, true}}, view);
    for (int line = 0; line < 9; ++line) {
      const auto reach = sight.reach(line);
      for (int e = 0; e < 12; ++e)
        EXPECT_EQ(reach && reach->first <= e && e < reach->end,
                  hits[static_cast<std::size_t>(line * 12 + e)] == 1)
            << "line " << line << " element " << e;
    }
  }
}

TEST(Sight, SamplesOnBordersBelongToOneOfTwoNeighbours) {
  // A square of two triangles whose corners and diagonal lie exactly on samples.
  Viewpoint viewpoint;
  ViewTransform view;
  view.rotation = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};
  view.focal = 8;
  view.raster = {16, 16};
  const auto corner = [](double column, double row) {
    return Vec3{column + 0.5 - 8, 8, 8 - row - 0.5};
  };
  const Triangle a{corner(4, 4), corner(12, 12), corner(12, 4)};
  const Triangle b{corner(4, 4), corner(4, 12), corner(12, 12)};
  const Sight one(a, view), two(b, view);
  for (int line = 0; line < 16; ++line) {
    const auto p = one.reach(line), q = two.reach(line);
    std::vector<int> covered(16, 0);
    for (const auto& reach : {p, q})
      if (reach)
        for (int e = reach->first; e < reach->end; ++e) ++covered[static_cast<std::size_t>(e)];
    for (int e = 0; e < 16; ++e)
      EXPECT_EQ(covered[static_cast<std::size_t>(e)],
                line >= 4 && line < 12 && e >= 4 && e < 12 ? 1 : 0)
          << "line " << line << " element " << e;
  }
  EXPECT_TRUE(one.whole());
  EXPECT_EQ(one.first_line(), 4);
  EXPECT_EQ(one.end_line(), 12);
}

TEST(Sight, MeasuresHowFarAnEdgeIsOff) {
  ViewTransform view;
  view.rotation = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};
  view.focal = 8;
  view.raster = {16, 16};
  // An upright border at column 4, that is 3.5 from the first sample.
  const Triangle t{Vec3{-4, 8, 8}, Vec3{-4, 8, -8}, Vec3{8, 8, 0}};
  const Sight sight(t, view);
  EXPECT_DOUBLE_EQ(sight.distance_from_border(7, Exact(3.5), true), 0);
  EXPECT_DOUBLE_EQ(sight.distance_from_border(7, Exact(3.75), true), 0.25);
}

// A sample is as far from a level border as from an upright one.
TEST(Sight, MeasuresHowFarASampleIsInside) {
  ViewTransform view;
  view.rotation = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};
  view.focal = 8;
  view.raster = {16, 16};
  // Borders at column 4, at line 12, and from (4, -8) to (24, 12).
  const Triangle t{Vec3{-4, 8, -4}, Vec3{16, 8, -4}, Vec3{-4, 8, 16}};
  const Sight sight(t, view);
  EXPECT_DOUBLE_EQ(sight.distance_from_all(9, 12), 2.5);
  EXPECT_DOUBLE_EQ(sight.distance_from_all(9, 5), 1.5);
  EXPECT_DOUBLE_EQ(sight.distance_from_all(2, 13), 0.5 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(sight.distance_from_all(9, 15), 0.5);
  EXPECT_DOUBLE_EQ(sight.distance_from_all(14, 10), 1.5);
}

// Planted: a format that draws nothing of a wide triangle, and one that draws half of it. No edge
// is off, as there is none; the claim does not hold all the same.
TEST(JudgeCover, WhatIsMissingIsBeyondTheClaim) {
  Random random(1);
  const Instance instance = pose_face({}, {}, random);
  const Triangle t = corners(instance);
  const ViewTransform& view = instance.view;
  const Sight sight(t, view);
  const Format exact = format_named("exact");
  Drawing drawing = draw({&t, 1}, true, view, exact);
  const auto judge = [&] { return judge_cover(drawing, 0, sight, view.raster, kDoubleClaim); };
  EXPECT_EQ(judge().verdict, Verdict::kRight);
  EXPECT_EQ(judge().error, 0);
  drawing.edges.clear();
  for (Crossing& crossing : drawing.crossings.crossings)
    if (!crossing.left) crossing.element -= 6;
  EXPECT_EQ(judge().verdict, Verdict::kWrong);
  EXPECT_GT(judge().error, 1);
  Drawing nothing;
  nothing.crossings.first.assign(static_cast<std::size_t>(view.raster.height) + 1, 0);
  drawing = nothing;
  EXPECT_EQ(judge().verdict, Verdict::kWrong);
  EXPECT_GT(judge().error, 1);
}

TEST(ExactSide, IsThatOfThePlanesOwnTest) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    Extremes extremes;
    extremes.ulps = random.below(4);
    const PlaneDefinition plane = plane_of(triangle_of({}, extremes, random));
    const Vec3 point =
        near_border(random_direction(random), border_of(plane), *extremes.ulps, random);
    EXPECT_EQ(exact_side(plane, point), side(make_plane(plane), point)) << "seed " << seed;
    EXPECT_LT(distance_from(plane, point), 1e-14) << "seed " << seed;
  }
}

TEST(NearBorder, IsOffByTheUlpsAskedFor) {
  const Border level{{0, 0, Exact(1)}, {0, 0, Exact(0.1)}};
  Random random(1);
  EXPECT_EQ(near_border({3, 4, 5}, level, 0, random), (Vec3{3, 4, 0.1}));
  for (int i = 0; i < 10; ++i)  // the largest coordinate is 4: an ulp is 2^-50
    EXPECT_EQ(std::abs(near_border({3, 4, 5}, level, 3, random).z - 0.1), 3 * 0x1p-50);
  EXPECT_EQ(near_border({3, 4, 5}, {{}, {}}, 1, random), (Vec3{3, 4, 5}));
}

std::vector<Vec3> some_points(Random& random, std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
  return points;
}

TEST(ExactSphere, ProvesSmallestSpheresAndNoOthers) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const std::vector<Vec3> points = some_points(random, 8);
    const BoundingSphere sphere = minimum_sphere(points);
    const SphereProof proof = prove(sphere, points);
    EXPECT_TRUE(proof.right);
    EXPECT_LE(proof.excess, proof.bound);

    BoundingSphere shrunk = sphere;
    shrunk.radius = std::nextafter(sphere.radius * (1 - 0x1p-50), 0);
    EXPECT_FALSE(prove(shrunk, points).right);
    BoundingSphere swollen = sphere;
    swollen.radius *= 1 + 0x1p-40;
    EXPECT_GT(prove(swollen, points).excess, prove(swollen, points).bound);
    BoundingSphere other = sphere;  // rests on fewer points
    other.support.pop_back();
    EXPECT_FALSE(prove(other, points).right);
  }
}

}  // namespace
}  // namespace cigsim::stability
