// SPDX-License-Identifier: MIT
#include "models/database/bsp/traversal.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/database/bsp/build.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/random.hpp"
#include "tests/database/bsp/exact_polygon.hpp"
#include "tests/support/cases.hpp"

namespace cigsim {
namespace {

using test::exact_loop;
using test::hit;
using test::polygons_of;

constexpr BspRule kRules[] = {BspRule::kFirst, BspRule::kFewestSplits, BspRule::kConflicts,
                              BspRule::kCost};

Vec3 random_point(Random& random, double low, double high) {
  return {random.between(low, high), random.between(low, high), random.between(low, high)};
}

// Along the ray the polygon of highest priority is the nearest one.
void expect_nearest_first(const BspTree& tree, const BspPolygons& input,
                          const std::vector<std::uint32_t>& priority, const Vec3& eye_point,
                          const Vec3& direction) {
  const ExactVec eye = convert<Exact>(eye_point), d = convert<Exact>(direction);
  std::optional<Exact> nearest;
  for (std::uint32_t p = 0; p < input.set.items.size(); ++p)
    if (const auto t = hit(exact_loop(input.set, p), eye, d); t && (!nearest || *t < *nearest))
      nearest = t;
  std::uint32_t highest = 0;
  std::optional<Exact> seen;
  for (std::size_t m = 0; m < tree.members.size(); ++m) {
    if (priority[m] < highest) continue;
    if (const auto t = hit(exact_loop(tree.set, tree.members[m]), eye, d)) {
      highest = priority[m];
      seen = t;
    }
  }
  EXPECT_EQ(seen, nearest);
}

TEST(VisibilityPriorities, AgreeWithExactRayCasting) {
  const unsigned rays = test::cases(40);
  for (const char* kind : {"city", "random", "brushes", "soup"})
    for (const BspRule rule : kRules) {
      SCOPED_TRACE(testing::Message() << kind << " rule " << static_cast<int>(rule));
      const BspPolygons input = bsp_polygons(generate_environment(kind, {8, 9}));
      BspOptions options;
      options.root.rule = rule;
      const BspTree tree = build_bsp(input, options);
      Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
      for (const WorkItem& item : input.set.items) {
        low = {std::min(low.x, item.low[0]), std::min(low.y, item.low[1]),
               std::min(low.z, item.low[2])};
        high = {std::max(high.x, item.high[0]), std::max(high.y, item.high[1]),
                std::max(high.z, item.high[2])};
      }
      Random random(17);
      for (unsigned r = 0; r < rays; ++r) {
        const Vec3 share = random_point(random, -0.3, 1.3), aim = random_point(random, 0, 1);
        const Vec3 size = high - low;
        const Vec3 eye = low + Vec3{size.x * share.x, size.y * share.y, size.z * share.z};
        const Vec3 target = low + Vec3{size.x * aim.x, size.y * aim.y, size.z * aim.z};
        expect_nearest_first(tree, input, visibility_priorities(tree, eye), eye, target - eye);
      }
    }
}

// Eyepoints at corners and in planes of the polygons.
TEST(VisibilityPriorities, AgreeWhereTheEyeIsInAPlane) {
  const BspPolygons input = bsp_polygons(generate_environment("brushes", {10, 4}));
  const BspTree tree = build_bsp(input);
  Random random(5);
  for (unsigned r = 0; r < test::cases(150); ++r) {
    const std::uint32_t v = random.below(input.set.vertex_count());
    const Vec3 eye = input.set.vertex(v);
    expect_nearest_first(tree, input, visibility_priorities(tree, eye), eye,
                         random_point(random, -1, 1));
  }
}

TEST(Traversal, BothWaysAndNumbersAgree) {
  const BspTree tree = build_bsp(bsp_polygons(generate_environment("soup", {30, 1})));
  const Vec3 eye{3, 4, 5};
  std::vector<std::uint32_t> back = back_to_front(tree, eye), front = front_to_back(tree, eye);
  const std::vector<std::uint32_t> priority = visibility_priorities(tree, eye);
  ASSERT_EQ(back.size(), tree.members.size());
  for (std::size_t m = 0; m < priority.size(); ++m)
    EXPECT_EQ(back[priority[m] - 1], tree.members[m]);
  std::reverse(front.begin(), front.end());
  EXPECT_EQ(back, front);
}

TEST(Traversal, OfCoplanarPolygonsTheFirstOfTheSceneIsNearestFromBothSides) {
  const std::vector<Vec3> a{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const BspTree tree = build_bsp(polygons_of({a, a, a}));
  for (const double z : {1.0, -1.0, 0.0})
    EXPECT_EQ(visibility_priorities(tree, {0, 0, z}), (std::vector<std::uint32_t>{3, 2, 1}));
}

TEST(Traversal, OfNothing) {
  EXPECT_TRUE(back_to_front(build_bsp({}), {0, 0, 0}).empty());
  EXPECT_TRUE(visibility_priorities(build_bsp({}), {0, 0, 0}).empty());
}

// Level polygons from the top down, told to be of one body, so that the build need not compare each
// with all others: a chain as deep as it is long.
TEST(Traversal, ChainOf200000Polygons) {
  constexpr int kDepth = 200000;
  std::vector<std::vector<Vec3>> loops;
  for (int i = 0; i < kDepth; ++i) {
    const double z = -i;
    loops.push_back({{0, 0, z}, {1, 0, z}, {0, 1, z}});
  }
  BspPolygons input = polygons_of(loops);
  std::fill(input.body.begin(), input.body.end(), 1);
  const BspTree tree = build_bsp(std::move(input));
  EXPECT_EQ(tree.depth, static_cast<std::uint64_t>(kDepth));
  const auto above = front_to_back(tree, {0, 0, 1}), below = front_to_back(tree, {0, 0, -1e9});
  EXPECT_EQ(above.front(), 0u);
  EXPECT_EQ(above.back(), static_cast<std::uint32_t>(kDepth - 1));
  EXPECT_EQ(below.front(), static_cast<std::uint32_t>(kDepth - 1));
}

}  // namespace
}  // namespace cigsim
