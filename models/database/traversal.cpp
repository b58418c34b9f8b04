// SPDX-License-Identifier: MIT
#include "models/database/traversal.hpp"

namespace cigsim {

std::vector<std::uint32_t> ranks_from(const PriorityHierarchy& hierarchy, std::size_t item_count,
                                      const Vec3& eye) {
  struct Place {
    std::uint32_t group;
    std::int32_t child;
  };
  std::vector<std::uint32_t> ranks(item_count, 0);
  if (hierarchy.groups.empty()) return ranks;
  std::uint32_t next = 0;
  std::vector<Place> stack;
  const auto push_root = [&](std::uint32_t group) {
    const Group& g = hierarchy.groups[group];
    if (g.choice == kNone) {
      stack.push_back({group, g.node_count > 0 ? 0 : -1});
      return;
    }
    // Descriptions are never active together; any order will do.
    for (std::uint32_t m = 0; m < g.member_count; ++m)
      stack.push_back({group, ~static_cast<std::int32_t>(m)});
  };
  push_root(0);
  while (!stack.empty()) {
    const auto [g, child] = stack.back();
    stack.pop_back();
    const Group& group = hierarchy.groups[g];
    if (child < 0) {
      const Member& m = hierarchy.members[group.first_member + static_cast<std::uint32_t>(~child)];
      if (m.is_group)
        push_root(m.index);
      else
        ranks[m.index] = next++;
      continue;
    }
    const SeparationNode& node =
        hierarchy.nodes[group.first_node + static_cast<std::uint32_t>(child)];
    const bool eye_true = side(hierarchy.planes[node.plane], eye) >= 0;
    stack.push_back({g, eye_true ? node.false_child : node.true_child});
    stack.push_back({g, eye_true ? node.true_child : node.false_child});
  }
  return ranks;
}

std::vector<std::uint32_t> leaves_from(const Partition& partition, const Vec3& eye) {
  std::vector<std::uint32_t> order;
  if (partition.leaves.empty()) return order;
  std::vector<std::int32_t> stack{partition.root};
  while (!stack.empty()) {
    const std::int32_t child = stack.back();
    stack.pop_back();
    if (child < 0) {
      order.push_back(static_cast<std::uint32_t>(~child));
      continue;
    }
    const PartitionNode& node = partition.nodes[static_cast<std::size_t>(child)];
    const bool eye_true = side(partition.planes[node.plane], eye) >= 0;
    stack.push_back(eye_true ? node.false_child : node.true_child);
    stack.push_back(eye_true ? node.true_child : node.false_child);
  }
  return order;
}

}  // namespace cigsim
