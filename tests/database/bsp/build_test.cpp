// SPDX-License-Identifier: MIT
#include "models/database/bsp/build.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "models/environment/generate.hpp"
#include "tests/database/bsp/exact_polygon.hpp"

namespace cigsim {
namespace {

using test::area_vector;
using test::exact_loop;
using test::polygons_of;
using test::side_of_loop;

constexpr BspRule kRules[] = {BspRule::kFirst, BspRule::kFewestSplits, BspRule::kConflicts,
                              BspRule::kCost};

BspOptions options_of(BspRule rule, std::uint32_t candidates = 0) {
  BspOptions options;
  options.root.rule = rule;
  options.root.candidates = candidates;
  return options;
}

// Every polygon of a subtree is on its side of each plane above it, and a node's own lie in it.
void expect_right_sides(const BspTree& tree) {
  struct Constraint {
    std::uint32_t plane;
    int side;
  };
  struct Step {
    std::uint32_t node;
    std::vector<Constraint> above;
  };
  std::vector<Step> steps;
  if (!tree.nodes.empty()) steps.push_back({0, {}});
  while (!steps.empty()) {
    const Step step = std::move(steps.back());
    steps.pop_back();
    const BspNode& node = tree.nodes[step.node];
    for (std::uint32_t m = node.first; m < node.first + node.count; ++m) {
      const test::ExactLoop loop = exact_loop(tree.set, tree.members[m]);
      EXPECT_EQ(side_of_loop(tree.set.planes[node.plane], loop), 0);
      for (const Constraint& c : step.above)
        EXPECT_EQ(side_of_loop(tree.set.planes[c.plane], loop), c.side);
    }
    for (const int side : {1, -1}) {
      const std::uint32_t child = side > 0 ? node.positive : node.negative;
      if (child == BspNode::kLeaf) continue;
      Step next{child, step.above};
      next.above.push_back({node.plane, side});
      steps.push_back(std::move(next));
    }
  }
}

// The parts of each polygon have its area, and face as it does.
void expect_whole_polygons(const BspTree& tree, const BspPolygons& input) {
  std::vector<ExactVec> area(input.set.items.size());
  for (const std::uint32_t item : tree.members) {
    const std::uint32_t order = tree.polygon(item).origin.order;
    const ExactVec part = area_vector(exact_loop(tree.set, item));
    EXPECT_GT(dot(part, area_vector(exact_loop(input.set, order))), 0);
    area[order] = area[order] + part;
  }
  for (std::uint32_t p = 0; p < area.size(); ++p)
    EXPECT_TRUE(area[p] == area_vector(exact_loop(input.set, p))) << "polygon " << p;
}

void expect_tree(const BspPolygons& input, const BspOptions& options) {
  const BspTree tree = build_bsp(input, options);
  EXPECT_EQ(tree.polygons, input.set.items.size());
  EXPECT_EQ(tree.members.size(), tree.polygons + tree.splits);
  std::uint64_t without = 0;
  for (const BspNode& node : tree.nodes) without += node.count == 0;
  EXPECT_EQ(tree.dividing_planes, without);
  expect_right_sides(tree);
  expect_whole_polygons(tree, input);
}

TEST(BuildBsp, EveryPieceIsOnItsSideAndNoAreaIsLost) {
  for (const char* kind : {"city", "random", "brushes", "soup"})
    for (const BspRule rule : kRules)
      for (const std::uint32_t candidates : {0u, 5u}) {
        SCOPED_TRACE(testing::Message()
                     << kind << " rule " << static_cast<int>(rule) << " candidates " << candidates);
        expect_tree(bsp_polygons(generate_environment(kind, {12, 7})),
                    options_of(rule, candidates));
      }
}

TEST(BuildBsp, DividingPlanesPartALargeList) {
  BspOptions options = options_of(BspRule::kCost);
  const BspPolygons input = bsp_polygons(generate_environment("random", {40, 3}));
  expect_tree(input, options);
  options.root.dividing_planes = false;
  EXPECT_EQ(build_bsp(input, options).dividing_planes, 0u);
}

TEST(BuildBsp, NothingIn) {
  const BspTree tree = build_bsp({});
  EXPECT_TRUE(tree.nodes.empty());
  EXPECT_EQ(tree.depth, 0u);
  EXPECT_EQ(tree.leaves(), 1u);
}

TEST(BuildBsp, OnePolygon) {
  const BspTree tree = build_bsp(polygons_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.nodes[0].count, 1u);
  EXPECT_EQ(tree.depth, 1u);
}

TEST(BuildBsp, CoplanarAndDuplicatePolygonsShareANodeWhicheverWayTheyFace) {
  const std::vector<Vec3> up{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      down{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  for (const BspRule rule : kRules) {
    const BspTree tree = build_bsp(polygons_of({up, down, up, down}), options_of(rule));
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(tree.members, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  }
}

TEST(BuildBsp, TouchingPolygonsAreNotSplit) {
  // The second stands on the first, the third ends at the first's plane.
  const BspPolygons input = polygons_of({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                         {{0, -1, 0}, {0, 1, 0}, {0, 0, 1}},
                                         {{3, 0, 0}, {4, 0, -1}, {5, 1, -1}}});
  for (const BspRule rule : kRules) EXPECT_EQ(build_bsp(input, options_of(rule)).splits, 0u);
}

TEST(BuildBsp, HugeAndTinyCoordinates) {
  const double h = 0x1p200, t = 0x1p-200;
  const BspPolygons input = polygons_of({{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}},
                                         {{-t, 0, -t}, {t, 0, -t}, {t, t, h}},
                                         {{0, -t, -h}, {0, t, -t}, {0, t, t}}});
  for (const BspRule rule : kRules) expect_tree(input, options_of(rule));
}

TEST(BuildBsp, SameInputAndOptionsGiveTheSameTree) {
  const BspPolygons input = bsp_polygons(generate_environment("soup", {60, 5}));
  for (const BspRule rule : kRules) {
    const BspTree a = build_bsp(input, options_of(rule, 4)),
                  b = build_bsp(input, options_of(rule, 4));
    EXPECT_EQ(a.members, b.members);
    EXPECT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_EQ(a.depth, b.depth);
  }
}

TEST(BuildBsp, FacesOfAConvexBodyAreAChain) {
  const BspPolygons input = bsp_polygons(generate_environment("cubes", {1, 1}));
  const BspTree tree = build_bsp(input);
  EXPECT_EQ(tree.nodes.size(), 6u);
  EXPECT_EQ(tree.depth, 6u);
  expect_tree(input, {});
}

TEST(BspPolygons, LeavesOutWhatMovesAndCountsWhatWasRepaired) {
  Environment environment = generate_environment("cubes", {2, 1});
  environment.systems.push_back({"lift", {}, {{0, {}}}});
  environment.models.push_back({"moving", 1});
  environment.objects[1].model = static_cast<std::uint32_t>(environment.models.size() - 1);
  Object& cube = environment.objects[0];
  cube.faces.push_back(cube.faces[0]);
  const BspPolygons polygons = bsp_polygons(environment);
  EXPECT_EQ(polygons.moving_objects, 1u);
  EXPECT_EQ(polygons.faces, 7u);
  EXPECT_EQ(polygons.set.items.size(), 6u);
  ASSERT_EQ(polygons.notices.size(), 1u);
  EXPECT_EQ(polygons.notices[0].what, "duplicate face dropped");
}

TEST(BspPolygons, StandWhereTheirSystemStands) {
  Environment environment = generate_environment("cubes", {1, 1});
  environment.systems.push_back({"hill", {{100, 0, 0}, 90, 0, 0}, {}});
  environment.models[0].system = 1;
  const BspPolygons polygons = bsp_polygons(environment);
  ASSERT_EQ(polygons.set.items.size(), 6u);
  for (const WorkItem& item : polygons.set.items) EXPECT_GT(item.low[0], 90);
}

}  // namespace
}  // namespace cigsim
