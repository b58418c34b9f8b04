// SPDX-License-Identifier: MIT
// Where an eyepoint can be among planes, against elimination in rational numbers.
#include "models/database/listability/arrangement.hpp"

#include <gtest/gtest.h>

#include <set>

#include "models/database/listability/eyepoint.hpp"
#include "models/environment/random.hpp"
#include "tests/database/listability/half_spaces.hpp"

namespace cigsim::listability {
namespace {

// Planes of many kinds of position: few directions and few distances, so that planes coincide, run
// parallel, share lines and points; or anything.
std::vector<Plane> random_planes(Random& random, std::size_t count) {
  const int kind = static_cast<int>(random.below(4));
  std::vector<Plane> planes;
  while (planes.size() < count) {
    const auto small = [&](int span) {
      return static_cast<double>(random.below(2 * static_cast<unsigned>(span) + 1)) - span;
    };
    Vec3 n{small(1), small(1), kind == 1 ? 0 : small(1)}, p{small(1), small(1), small(1)};
    if (kind == 2) p = {0, 0, small(1)};
    if (kind == 3) {
      n = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      p = {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    }
    if (n == Vec3{}) continue;
    if (random.below(4) == 0) n = n * 3.0;
    planes.push_back(plane_with_normal(p, n));
  }
  return planes;
}

std::vector<EyeSide> sides_of(std::uint64_t eye_true, std::size_t planes) {
  std::vector<EyeSide> sides;
  for (std::uint32_t p = 0; p < planes; ++p) sides.push_back({p, (eye_true >> p & 1) != 0});
  return sides;
}

bool reachable(const std::vector<Plane>& planes, const std::vector<EyeSide>& sides) {
  std::vector<test::HalfSpace> spaces;
  for (const EyeSide& s : sides) spaces.push_back(test::half_space(planes[s.plane], s.eye_true));
  return test::have_common_point(std::move(spaces));
}

TEST(Arrangement, SidesOfThreePlanesAgainstElimination) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int impossible = 0;
  for (int k = 0; k < 1500; ++k) {
    const std::vector<Plane> planes = random_planes(random, 1 + random.below(3));
    const Arrangement eyes(planes);
    for (std::uint64_t mask = 0; mask < std::uint64_t{1} << planes.size(); ++mask) {
      const std::vector<EyeSide> sides = sides_of(mask, planes.size());
      const bool want = reachable(planes, sides);
      ASSERT_EQ(eyes.can_see(sides), want) << "case " << k << " mask " << mask;
      impossible += !want;
      const auto point = eyes.point_with(sides, 1);
      ASSERT_EQ(point.has_value(), want);
      if (!point) continue;
      for (const EyeSide& s : sides) ASSERT_EQ(eye_is_true(planes[s.plane], *point), s.eye_true);
    }
  }
  EXPECT_GT(impossible, 400);
}

TEST(Arrangement, AllCellsAgainstElimination) {
  const std::uint64_t seed = 8;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int k = 0; k < 120; ++k) {
    const std::vector<Plane> planes = random_planes(random, random.below(7));
    const Arrangement eyes(planes);
    std::set<std::uint64_t> found;
    eyes.for_each_cell([&](std::uint64_t eye_true, const CellPath& path) {
      EXPECT_TRUE(found.insert(eye_true).second) << "each once";
      const ExactVec point = eyes.point_of(path, 100);
      for (const EyeSide& s : sides_of(eye_true, planes.size()))
        EXPECT_EQ(eye_is_true(planes[s.plane], point), s.eye_true);
      return true;
    });
    for (std::uint64_t mask = 0; mask < std::uint64_t{1} << planes.size(); ++mask)
      ASSERT_EQ(found.count(mask) > 0, reachable(planes, sides_of(mask, planes.size())))
          << "case " << k << " mask " << mask;
  }
}

TEST(Arrangement, CellsOfPlanesInGeneralPosition) {
  const std::uint64_t seed = 9;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::vector<Plane> planes;
  for (std::size_t n = 0; n <= 12; ++n) {
    // n planes make 1 + n + C(n,2) + C(n,3) cells.
    std::size_t cells = 0;
    Arrangement(planes).for_each_cell([&](std::uint64_t, const CellPath&) {
      ++cells;
      return true;
    });
    EXPECT_EQ(cells, 1 + n + n * (n - 1) / 2 + n * (n - 1) * (n - 2) / 6);
    planes.push_back(
        plane_with_normal({random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)},
                          {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}));
  }
}

TEST(Arrangement, OppositePlanesMeetOnlyOnThePlane) {
  const std::vector<Plane> planes{plane_with_normal({5, 0, 0}, {1, 0, 0}),
                                  plane_with_normal({5, 0, 0}, {-1, 0, 0})};
  const Arrangement eyes(planes);
  const std::vector<EyeSide> both{{0, true}, {1, true}}, neither{{0, false}, {1, false}};
  EXPECT_TRUE(eyes.can_see(both)) << "on the plane counts as TRUE";
  EXPECT_FALSE(eyes.can_see(neither));
  const auto point = eyes.point_with(both, 1);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->x, 5);
}

TEST(Arrangement, APlaneWithoutNormalHasOneSide) {
  const std::vector<Plane> planes{make_plane({{1, 2, 3}, {}, {1, 0, 0}, {}, {2, 0, 0}})};
  const Arrangement eyes(planes);
  const std::vector<EyeSide> on{{0, true}}, off{{0, false}};
  EXPECT_TRUE(eyes.can_see(on));
  EXPECT_FALSE(eyes.can_see(off));
}

TEST(Eyepoint, ARoundPointIsPreferred) {
  const std::vector<Plane> planes{plane_with_normal({0.3, 0, 0}, {1, 0, 0})};
  const std::vector<EyeSide> sides{{0, true}};
  const Eyepoint eye =
      eyepoint_near({Exact(1000001, 999999), Exact(1, 3), Exact(0)}, planes, sides);
  ASSERT_TRUE(eye.rounded);
  EXPECT_EQ(*eye.rounded, (Vec3{2, 0, 0}));
  EXPECT_EQ(text_of(eye), "2,0,0");
}

TEST(Eyepoint, APointThatNoDoubleReachesIsAFraction) {
  // Only x = 1/3 is on the TRUE side of both: 3 x >= 1 and -3 x >= -1.
  const std::vector<Plane> planes{make_plane({{0, 1, 0}, {}, {0, 0, 1}, {1, -2, 0}, {0, 1, 0}}),
                                  make_plane({{0, 1, 0}, {1, -2, 0}, {0, 1, 0}, {}, {0, 0, 1}})};
  // Both contain the z axis' direction and the line from (0, 1) to (1, -2).
  const Arrangement eyes(planes);
  const std::vector<EyeSide> sides{{0, true}, {1, true}};
  const auto point = eyes.point_with(sides, 1);
  ASSERT_TRUE(point);
  for (const Plane& plane : planes) EXPECT_EQ(side(plane, *point), 0);
  const Eyepoint eye = eyepoint_near(*point, planes, sides);
  if (!eye.rounded) {
    EXPECT_NE(text_of(eye).find('/'), std::string::npos);
  } else {
    for (const Plane& plane : planes) EXPECT_EQ(side(plane, *eye.rounded), 0);
  }
}

}  // namespace
}  // namespace cigsim::listability
