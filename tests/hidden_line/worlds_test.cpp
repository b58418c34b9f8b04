// SPDX-License-Identifier: MIT
// Hidden lines of random worlds from awkward eyepoints, against rational rays.
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include "models/frame_calculator/functional.hpp"
#include "tests/hidden_line/oracle.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

using hidden_line::HiddenLines;

// Several views of each of several worlds; `solids` when invisibility counts can be checked too.
template <class MakeWorld>
SampleCounts check_worlds(std::uint64_t seed, unsigned worlds, MakeWorld make, bool solids) {
  SampleCounts counts;
  for (unsigned w = 0; w < worlds; ++w) {
    SCOPED_TRACE("seed " + std::to_string(seed + w));
    Random random(seed + w);
    const World world = make(random);
    HiddenLines lines(parts_of(world.environment));
    for (int v = 0; v < 4; ++v) {
      SCOPED_TRACE("view " + std::to_string(v));
      const Viewpoint viewpoint = random_viewpoint(world.environment, random);
      const ViewTransform view = frame_calculator::view_transform(viewpoint, {640, 480});
      lines.compute(view, true);
      EXPECT_EQ(check_pieces(lines, view, 3, counts), "");
      if (solids) {
        EXPECT_EQ(check_invisibility(lines, view), "");
      }
      if (::testing::Test::HasFailure()) return counts;
    }
  }
  return counts;
}

TEST(HiddenLineWorlds, SolidsApart) {
  const SampleCounts counts = check_worlds(
      1, cases(6), [](Random& random) { return disjoint_world(random, 12); }, true);
  EXPECT_GT(counts.hidden, 0u);
  EXPECT_LT(counts.boundary, counts.samples);
}

TEST(HiddenLineWorlds, SolidsThatTouch) {
  check_worlds(
      1000, cases(15), [](Random& random) { return touching_world(random); }, true);
}

// Pairs that no plane parts are decided by their depth.
TEST(HiddenLineWorlds, SolidsThroughEachOther) {
  check_worlds(
      2000, cases(6), [](Random& random) { return body_soup(random, 10); }, true);
  check_worlds(
      2500, cases(8), [](Random& random) { return grid_boxes(random, 10); }, true);
}

TEST(HiddenLineWorlds, SolidsWithinSolids) {
  check_worlds(
      3000, cases(30), [](Random& random) { return nested_world(random); }, false);
}

TEST(HiddenLineWorlds, TrianglesThroughEachOther) {
  check_worlds(
      4000, cases(30), [](Random& random) { return triangle_soup(random, 12); }, false);
}

TEST(HiddenLineWorlds, BodiesOnASmallLattice) {
  check_worlds(
      5000, cases(40), [](Random& random) { return lattice_world(random, 8); }, false);
}

TEST(HiddenLineWorlds, ConcaveBodies) {
  check_worlds(
      6000, cases(5), [](Random& random) { return cell_bodies(random, 3); }, false);
}

TEST(HiddenLineWorlds, CoplanarFigures) {
  check_worlds(
      7000, cases(30), [](Random& random) { return coplanar_polygons(random, 10); }, false);
}

}  // namespace
}  // namespace cigsim::test
