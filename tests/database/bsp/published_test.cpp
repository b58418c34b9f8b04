// SPDX-License-Identifier: MIT
// What Fuchs, Kedem and Naylor 1980 published: Table 1, the trees of figs. 7 to 12, Table 2.
#include <gtest/gtest.h>

#include <filesystem>

#include "models/database/bsp/bounds.hpp"
#include "models/database/bsp/build.hpp"
#include "models/environment/read.hpp"
#include "tests/database/bsp/exact_polygon.hpp"

namespace cigsim {
namespace {

using test::polygons_of;
using Loops = std::vector<std::vector<Vec3>>;

BspPolygons scene(const char* name) {
  return bsp_polygons(
      read_environment(std::filesystem::path(CIGSIM_SOURCE_DIR) / "scenes" / name).environment);
}

BspTree tree_of(BspPolygons polygons, BspRule rule) {
  BspOptions options;
  options.root.rule = rule;
  return build_bsp(std::move(polygons), options);
}

void expect_row(const char* name, std::size_t original, std::size_t in_tree) {
  const BspTree tree = tree_of(scene(name), BspRule::kFewestSplits);
  EXPECT_EQ(tree.polygons, original);
  EXPECT_EQ(tree.members.size(), in_tree);
  EXPECT_EQ(tree.splits, in_tree - original);
}

TEST(FuchsTable1, Fig4ElevenPolygonsStayEleven) { expect_row("fuchs-house.json", 11, 11); }
TEST(FuchsTable1, Fig5SeventyTwoPolygonsBecomeAHundred) {
  expect_row("fuchs-blocks.json", 72, 100);
}
TEST(FuchsTable1, Fig6ThreePolygonsBecomeFive) { expect_row("fuchs-overlap.json", 3, 5); }

TEST(FuchsFig8, PlaneOfBSplitsAAndCIntoTwo) {
  BspPolygons polygons = scene("fuchs-overlap.json");
  // Each of the three planes splits the two others; such ties go to the first.
  std::swap(polygons.set.items[0], polygons.set.items[1]);
  const BspTree tree = tree_of(std::move(polygons), BspRule::kFewestSplits);
  ASSERT_EQ(tree.members.size(), 5u);
  std::vector<int> parts(3);
  for (const std::uint32_t item : tree.members) ++parts[tree.polygon(item).origin.order];
  EXPECT_EQ(parts, (std::vector<int>{2, 1, 2}));
  EXPECT_EQ(tree.polygon(tree.members[0]).origin.order, 1u) << "B is the root";
}

// A segment of the plane as an upright polygon one unit high.
std::vector<Vec3> upright(double x0, double y0, double x1, double y1) {
  return {{x0, y0, 0}, {x1, y1, 0}, {x1, y1, 1}, {x0, y0, 1}};
}

TEST(FuchsFig10And12, OrderOfSelectionGivesFiveAreasOrFour) {
  const auto a = upright(-5, 0, -3, 0), b = upright(-5, 3, -3, 3), c = upright(0, -2, 0, 2);
  EXPECT_EQ(tree_of(polygons_of({a, b, c}), BspRule::kFirst).leaves(), 5u);
  EXPECT_EQ(tree_of(polygons_of({c, b, a}), BspRule::kFirst).leaves(), 4u);
}

// The source once writes 2n + 1 nodes for n areas; it is 2n - 1, as its own 2 f - 1 says.
TEST(FuchsLeaves, AreOneMoreThanInnerNodes) {
  for (const char* name : {"fuchs-house.json", "fuchs-blocks.json", "fuchs-overlap.json"}) {
    const BspTree tree = tree_of(scene(name), BspRule::kFewestSplits);
    std::size_t empty_sons = 0;
    for (const BspNode& node : tree.nodes)
      empty_sons += (node.positive == BspNode::kLeaf) + (node.negative == BspNode::kLeaf);
    EXPECT_EQ(empty_sons, tree.nodes.size() + 1);
    EXPECT_EQ(tree.leaves(), empty_sons);
  }
}

// Pieces of all objects when each is cut by the planes of all others.
std::uint64_t arrangement_pieces(const Loops& loops) {
  BspPolygons polygons = polygons_of(loops);
  WorkSet& set = polygons.set;
  std::uint64_t pieces = 0;
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    std::vector<std::uint32_t> parts{i};
    for (std::uint32_t j = 0; j < loops.size(); ++j) {
      if (j == i) continue;
      std::vector<std::uint32_t> cut;
      const Plane plane = set.planes[j];
      for (const std::uint32_t p : parts) {
        if (set.classify(plane, set.items[p]) != 2) {
          cut.push_back(p);
          continue;
        }
        const auto halves = set.cut(plane, p);
        cut.insert(cut.end(), halves.begin(), halves.end());
      }
      parts = cut;
    }
    pieces += parts.size();
  }
  return pieces;
}

// The tangent of y = x^2 at t over a range of x.
std::vector<Vec3> tangent(double t, double x0, double x1) {
  return upright(x0, 2 * t * x0 - t * t, x1, 2 * t * x1 - t * t);
}

// A rectangle of the plane t^3 + a t^2 + b t + c = 0 in (a, b, c). Three such planes meet in the
// polynomial with the three roots, so that no four meet.
std::vector<Vec3> root_plane(double t, double a0, double a1, double b0, double b1) {
  const auto at = [&](double a, double b) { return Vec3{a, b, -(t * t * t + a * t * t + b * t)}; };
  return {at(a0, b0), at(a1, b0), at(a1, b1), at(a0, b1)};
}

void expect_tree_reaches_bound(unsigned d, const Loops& loops) {
  const std::uint64_t n = loops.size();
  const BspTree tree = tree_of(polygons_of(loops), BspRule::kFirst);
  EXPECT_EQ(tree.leaves(), most_volumes(d, n)) << n;
  EXPECT_EQ(tree.members.size(), most_nodes(d, n)) << n;
}

TEST(FuchsTable2, FormulasAreThoseOfTheTable) {
  for (std::uint64_t n = 1; n <= 100; ++n) {
    EXPECT_EQ(most_volumes(2, n), (n * n + n) / 2 + 1);
    EXPECT_EQ(most_unbounded_pieces(2, n), n * n);
    EXPECT_EQ(most_bounded_pieces(2, n), (n * n + n) / 2);
    EXPECT_EQ(most_volumes(3, n), (n * n * n + 5 * n) / 6 + 1);
    EXPECT_EQ(most_unbounded_pieces(3, n), (n * n * n - n * n + 2 * n) / 2);
    EXPECT_EQ(most_bounded_pieces(3, n), (n * n * n + 3 * n * n + 2 * n) / 6);
    EXPECT_EQ(most_nodes(3, n), (n * n * n + 5 * n) / 6);
  }
  EXPECT_EQ(most_unbounded_pieces(2, 0), 0u);
}

TEST(FuchsTable2, LinesInGeneralPosition) {
  for (int n = 1; n <= 9; ++n) {
    Loops lines;
    for (int t = 1; t <= n; ++t) lines.push_back(tangent(t, -100, 100));
    expect_tree_reaches_bound(2, lines);
    EXPECT_EQ(arrangement_pieces(lines), most_unbounded_pieces(2, lines.size()));
  }
}

// Tangents at 4, 16, 64 ...: the segment at t holds its crossings with all earlier lines, and none
// of the earlier segments does.
TEST(FuchsTable2, SegmentsThatDoNotMeet) {
  Loops segments;
  for (double t = 4; segments.size() < 9; t *= 4) {
    segments.push_back(tangent(t, t / 2, t * 3 / 4));
    expect_tree_reaches_bound(2, segments);
    EXPECT_EQ(arrangement_pieces(segments), most_bounded_pieces(2, segments.size()));
  }
}

TEST(FuchsTable2, PlanesInGeneralPosition) {
  for (int n = 1; n <= 7; ++n) {
    Loops planes;
    for (int t = 1; t <= n; ++t) planes.push_back(root_plane(t, -1000, 1000, -20000, 20000));
    expect_tree_reaches_bound(3, planes);
    EXPECT_EQ(arrangement_pieces(planes), most_unbounded_pieces(3, planes.size()));
  }
}

// The rectangle of t = 4^k holds the points where it meets two earlier planes (a is minus the sum
// of the roots, b the sum of their products), and no earlier rectangle reaches it. The tree is then
// as large as one of unbounded planes, and smaller than the table's figure from n = 2 on.
TEST(FuchsTable2, PolygonsThatDoNotMeet) {
  Loops polygons;
  for (double t = 4; polygons.size() < 7; t *= 4) {
    polygons.push_back(root_plane(t, -t * 1.5, -t, 0, t * t));
    expect_tree_reaches_bound(3, polygons);
    const std::uint64_t n = polygons.size();
    EXPECT_TRUE(n == 1 || most_nodes(3, n) < most_bounded_pieces(3, n));
  }
}

// The table's figure is that of the arrangement, and these reach it; their trees do not.
TEST(FuchsTable2, BoundedPolygonsCutEachOther) {
  const std::vector<Vec3> level{{-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
  const std::vector<Vec3> across{{0, 2, -1}, {0, 3, -1}, {0, 3, 1}, {0, 2, 1}};
  EXPECT_EQ(arrangement_pieces({level, across}), most_bounded_pieces(3, 2));
  EXPECT_EQ(tree_of(polygons_of({level, across}), BspRule::kFirst).members.size(), 3u);

  const std::vector<Vec3> p1{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const std::vector<Vec3> p2{{0, 2.5, -0.5}, {0, 2.75, -0.5}, {0, -0.25, 3}, {0, -0.5, 3}};
  const std::vector<Vec3> p3{{-2.5, 0, 0.5}, {-2.75, 0, 0.5}, {0.25, 0, -3}, {0.5, 0, -3}};
  EXPECT_EQ(arrangement_pieces({p1, p2, p3}), most_bounded_pieces(3, 3));
  EXPECT_LE(tree_of(polygons_of({p1, p2, p3}), BspRule::kFirst).members.size(), most_nodes(3, 3));
}

}  // namespace
}  // namespace cigsim
