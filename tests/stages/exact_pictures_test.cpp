// SPDX-License-Identifier: MIT
// Pictures of seeded random worlds against brute-force ray casting in rational arithmetic.
#include <gtest/gtest.h>

#include "tests/support/picture_check.hpp"

namespace cigsim::test {
namespace {

// Worlds of one kind, each from its own seed, which the messages tell.
template <class Make>
void check_worlds(std::uint64_t first_seed, int worlds, int views, Make make) {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + worlds; ++seed) {
    Random random(seed);
    const World world = make(random);
    check_world(world, random, views, 32, "seed " + std::to_string(seed), tally);
    if (::testing::Test::HasFailure()) return;
  }
  check_rate(tally);
}

TEST(ExactPictures, DisjointBodiesOverSixDecades) {
  check_worlds(1000, 40, 8, [](Random& r) { return disjoint_world(r, 2 + r.below(30)); });
}

TEST(ExactPictures, TouchingBodies) {
  check_worlds(2000, 40, 8, [](Random& r) { return touching_world(r); });
}

TEST(ExactPictures, TrianglesThatPassThroughEachOther) {
  check_worlds(3000, 25, 5, [](Random& r) { return triangle_soup(r, 2 + r.below(12)); });
}

TEST(ExactPictures, BodiesThatPassThroughEachOther) {
  check_worlds(4000, 25, 5, [](Random& r) { return body_soup(r, 2 + r.below(8)); });
}

TEST(ExactPictures, GridBoxesWithCoplanarFaces) {
  check_worlds(5000, 30, 8, [](Random& r) { return grid_boxes(r, 2 + r.below(8)); });
}

TEST(ExactPictures, CoplanarPolygonsThatOverlap) {
  check_worlds(6000, 150, 5, [](Random& r) { return coplanar_polygons(r, 2 + r.below(8)); });
}

TEST(ExactPictures, LatticesWhereEverythingCoincides) {
  check_worlds(8000, 100, 5, [](Random& r) { return lattice_world(r, 2 + r.below(8)); });
}

TEST(ExactPictures, WorldsOfSeveralKinds) {
  check_worlds(9000, 40, 4, [](Random& r) { return mixed_world(r); });
}

TEST(ExactPictures, ConcaveBodiesWithHolesAndCavities) {
  check_worlds(10000, 30, 6, [](Random& r) { return cell_bodies(r, 1 + r.below(3)); });
}

TEST(ExactPictures, BodiesWithinBodies) {
  check_worlds(7000, 20, 6, [](Random& r) { return nested_world(r); });
}

}  // namespace
}  // namespace cigsim::test
