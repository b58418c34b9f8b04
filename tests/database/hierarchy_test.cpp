// SPDX-License-Identifier: MIT
// What every prepared hierarchy must keep, verified in rational arithmetic on seeded random worlds.
#include "models/database/hierarchy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <set>

#include "models/database/prepare.hpp"
#include "models/database/traversal.hpp"
#include "models/priority_processor/functional.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

// Worlds of every kind, some of hundreds of objects. Every overlap is cut.
void for_each_world(const std::function<void(const World&, const Database&, Random&)>& check) {
  for (std::uint64_t seed = 1; seed <= 28; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world;
    switch (seed % 7) {
      case 0:
        world = disjoint_world(random, 150);
        break;
      case 1:
        world = touching_world(random);
        break;
      case 2:
        world = triangle_soup(random, 25);
        break;
      case 3:
        world = body_soup(random, 12);
        break;
      case 4:
        world = grid_boxes(random, 30);
        break;
      case 5:
        world = coplanar_polygons(random, 30);
        break;
      default:
        world = nested_world(random);
    }
    PrepareOptions options;
    options.contact_tolerance = 0;
    check(world, prepare(world.environment, options), random);
    if (::testing::Test::HasFailure()) return;
  }
}

ExactVec exact_vertex(const FaceSet& set, std::uint32_t vertex) {
  const auto at =
      std::lower_bound(set.cut_vertices.begin(), set.cut_vertices.end(), vertex,
                       [](const CutVertex& cut, std::uint32_t v) { return cut.vertex < v; });
  return at != set.cut_vertices.end() && at->vertex == vertex
             ? at->position
             : convert<Exact>(set.vertices[vertex]);
}

// Calls f(item) for every item below a child of a group's node.
template <class F>
void for_each_item(const PriorityHierarchy& h, std::uint32_t group, std::int32_t child, F f) {
  const Group& g = h.groups[group];
  if (child >= 0) {
    const SeparationNode& node = h.nodes[g.first_node + static_cast<std::uint32_t>(child)];
    for_each_item(h, group, node.true_child, f);
    for_each_item(h, group, node.false_child, f);
    return;
  }
  const Member& member = h.members[g.first_member + static_cast<std::uint32_t>(~child)];
  if (!member.is_group)
    f(member.index);
  else
    for_each_item(h, member.index, h.groups[member.index].node_count > 0 ? 0 : -1, f);
}

std::uint64_t mask_below(const PriorityHierarchy& h, const Group& group, std::int32_t child) {
  if (child < 0) return std::uint64_t{1} << ~child;
  const SeparationNode& node = h.nodes[group.first_node + static_cast<std::uint32_t>(child)];
  return mask_below(h, group, node.true_child) | mask_below(h, group, node.false_child);
}

TEST(Hierarchy, EveryPlanePartsWhatLiesOnItsTwoSidesExactly) {
  std::uint64_t tests = 0, in_plane = 0;
  for_each_world([&](const World&, const Database& database, Random&) {
    const FaceSet& set = database.systems[0].set;
    const PriorityHierarchy& h = database.systems[0].hierarchy;
    for (std::uint32_t g = 0; g < h.groups.size(); ++g)
      for (std::uint32_t n = 0; n < h.groups[g].node_count; ++n) {
        const SeparationNode& node = h.nodes[h.groups[g].first_node + n];
        const Plane& plane = h.planes[node.plane];
        const ExactVec normal = exact_normal(plane), p = convert<Exact>(plane.exact.p);
        ASSERT_FALSE(normal == ExactVec{});
        for (const int side : {1, -1})
          for_each_item(h, g, side > 0 ? node.true_child : node.false_child, [&](std::uint32_t i) {
            const Item& item = set.items[i];
            for (std::uint32_t v = item.first_vertex; v < item.first_vertex + item.vertex_count;
                 ++v) {
              const int s = sgn(dot(normal, exact_vertex(set, v) - p));
              ASSERT_GE(s * side, 0) << "group " << g << " node " << n << " item " << i;
              ++tests;
              in_plane += s == 0;
            }
          });
      }
  });
  std::cout << tests << " vertices tested, " << in_plane << " exactly in the plane\n";
  EXPECT_GT(in_plane, 1000u);
}

TEST(Hierarchy, GroupsAreTreesOfAtMost64MembersWithTheirMasks) {
  std::size_t largest = 0;
  for_each_world([&](const World&, const Database& database, Random&) {
    const PriorityHierarchy& h = database.systems[0].hierarchy;
    std::multiset<std::uint32_t> items, groups{0};
    for (const Group& group : h.groups) {
      ASSERT_LE(group.member_count, kGroupCapacity);
      ASSERT_GE(group.member_count, 1u);
      ASSERT_EQ(group.node_count, group.member_count - 1);
      largest = std::max<std::size_t>(largest, group.member_count);
      for (std::uint32_t m = 0; m < group.member_count; ++m) {
        const Member& member = h.members[group.first_member + m];
        (member.is_group ? groups : items).insert(member.index);
      }
      for (std::uint32_t n = 0; n < group.node_count; ++n) {
        const SeparationNode& node = h.nodes[group.first_node + n];
        ASSERT_EQ(node.true_members, mask_below(h, group, node.true_child));
        ASSERT_EQ(node.false_members, mask_below(h, group, node.false_child));
        ASSERT_EQ(node.true_members & node.false_members, 0u);
      }
    }
    ASSERT_EQ(items.size(), database.systems[0].set.items.size());
    ASSERT_EQ(std::set<std::uint32_t>(items.begin(), items.end()).size(), items.size());
    ASSERT_EQ(groups.size(), h.groups.size());
    ASSERT_EQ(std::set<std::uint32_t>(groups.begin(), groups.end()).size(), groups.size());
  });
  EXPECT_EQ(largest, kGroupCapacity) << "the cases must fill a group";
}

TEST(Hierarchy, SpheresHoldEverythingBelow) {
  for_each_world([](const World&, const Database& database, Random&) {
    const FaceSet& set = database.systems[0].set;
    const PriorityHierarchy& h = database.systems[0].hierarchy;
    for (std::uint32_t g = 0; g < h.groups.size(); ++g)
      for (std::uint32_t m = 0; m < h.groups[g].member_count; ++m) {
        const Sphere& sphere = h.members[h.groups[g].first_member + m].sphere;
        const ExactVec centre = convert<Exact>(sphere.centre);
        const Exact radius(sphere.radius);
        for_each_item(h, g, ~static_cast<std::int32_t>(m), [&](std::uint32_t i) {
          for (std::uint32_t v = 0; v < set.items[i].vertex_count; ++v) {
            const ExactVec d = exact_vertex(set, set.items[i].first_vertex + v) - centre;
            ASSERT_LE(dot(d, d), radius * radius) << "group " << g << " member " << m;
          }
        });
      }
  });
}

// Eyepoints all over the world, and exactly on its planes.
std::vector<Vec3> eyepoints(const World& world, const PriorityHierarchy& h, Random& random) {
  std::vector<Vec3> eyes;
  for (int k = 0; k < 60; ++k) {
    const Object& o = world.environment.objects[random.below(world.environment.objects.size())];
    eyes.push_back(o.vertices[0] + random_direction(random) * random.between(0, 10));
  }
  for (const Object& o : world.environment.objects)
    if (eyes.size() < 120) eyes.push_back(o.vertices[random.below(o.vertices.size())]);
  for (const Plane& plane : h.planes)
    if (eyes.size() < 200) eyes.push_back(plane.exact.p);
  return eyes;
}

TEST(Hierarchy, CountsAreAPermutationFromEveryEyepoint) {
  using namespace priority_processor;
  std::uint64_t orders = 0, on_plane = 0;
  for_each_world([&](const World& world, const Database& database, Random& random) {
    const PriorityHierarchy& h = database.systems[0].hierarchy;
    const std::size_t items = database.systems[0].set.items.size();
    for (const Vec3& eye : eyepoints(world, h, random)) {
      for (const Group& group : h.groups) {
        const std::span<const SeparationNode> nodes(&h.nodes[group.first_node], group.node_count);
        std::uint64_t eye_true = 0;
        for (std::size_t n = 0; n < nodes.size(); ++n) {
          const int s = side(h.planes[nodes[n].plane], eye);
          on_plane += s == 0;
          if (s >= 0) eye_true |= std::uint64_t{1} << n;
        }
        const std::uint64_t all = group.member_count == 64
                                      ? ~std::uint64_t{0}
                                      : (std::uint64_t{1} << group.member_count) - 1;
        for (const std::uint64_t active : {all, all & random.bits()}) {
          GroupOrder by_counters, by_matrix;
          order_by_counters(nodes, eye_true, active, by_counters);
          order_by_so_matrix(nodes, eye_true, active, by_matrix);
          ASSERT_TRUE(by_counters.unique);
          ASSERT_TRUE(by_matrix.unique);
          ASSERT_EQ(by_counters.count, static_cast<std::uint32_t>(std::popcount(active)));
          for (std::uint32_t k = 0; k < by_counters.count; ++k)
            ASSERT_EQ(by_counters.member[k], by_matrix.member[k]);
          ++orders;
        }
      }
      std::vector<std::uint32_t> ranks = ranks_from(h, items, eye);
      std::sort(ranks.begin(), ranks.end());
      for (std::uint32_t i = 0; i < ranks.size(); ++i) ASSERT_EQ(ranks[i], i);
    }
  });
  std::cout << orders << " orders, " << on_plane << " times exactly on a plane\n";
  EXPECT_GT(on_plane, 1000u);
}

TEST(Hierarchy, CutVerticesLieExactlyInTheirFaces) {
  std::uint64_t cut = 0;
  for_each_world([&](const World&, const Database& database, Random&) {
    const FaceSet& set = database.systems[0].set;
    cut += set.cut_vertices.size();
    ASSERT_TRUE(
        std::is_sorted(set.cut_vertices.begin(), set.cut_vertices.end(),
                       [](const CutVertex& a, const CutVertex& b) { return a.vertex < b.vertex; }));
    for (const Item& item : set.items)
      for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f)
        for (std::uint32_t c = 0; c < set.faces[f].corner_count; ++c) {
          const ExactVec v =
              exact_vertex(set, item.first_vertex + set.corners[set.faces[f].first_corner + c]);
          ASSERT_EQ(side(set.planes[set.faces[f].plane], v), 0);
        }
    for (const CutVertex& c : set.cut_vertices) {
      const Vec3& rounded = set.vertices[c.vertex];
      ASSERT_FALSE(convert<Exact>(rounded) == c.position) << "kept although a double holds it";
      for (const auto& [r, e] : {std::pair{rounded.x, &c.position.x},
                                 {rounded.y, &c.position.y},
                                 {rounded.z, &c.position.z}}) {
        ASSERT_LT(abs(Exact(r) - *e),
                  abs(Exact(std::nextafter(r, r > 0 ? 1e308 : -1e308)) - r) + Exact(0x1p-1000));
      }
    }
  });
  EXPECT_GT(cut, 1000u) << "the cases must cut";
}

}  // namespace
}  // namespace cigsim::test
