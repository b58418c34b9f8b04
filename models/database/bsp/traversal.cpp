// SPDX-License-Identifier: MIT
#include "models/database/bsp/traversal.hpp"

#include <algorithm>

namespace cigsim {
namespace {

// Calls `visit` with each node, the farthest first.
template <class Visit>
void visit_nodes(const BspTree& tree, const Vec3& eye, Visit visit) {
  struct Step {
    std::uint32_t node;
    bool entered;  // its far side is done
  };
  std::vector<Step> stack;
  if (!tree.nodes.empty()) stack.push_back({0, false});
  while (!stack.empty()) {
    const Step step = stack.back();
    stack.pop_back();
    const BspNode& node = tree.nodes[step.node];
    if (step.entered) {
      visit(node);
      continue;
    }
    const bool on_positive = side(tree.set.planes[node.plane], eye) >= 0;
    const std::uint32_t near = on_positive ? node.positive : node.negative;
    const std::uint32_t far = on_positive ? node.negative : node.positive;
    if (near != BspNode::kLeaf) stack.push_back({near, false});
    stack.push_back({step.node, true});
    if (far != BspNode::kLeaf) stack.push_back({far, false});
  }
}

}  // namespace

std::vector<std::uint32_t> back_to_front(const BspTree& tree, const Vec3& eye) {
  std::vector<std::uint32_t> order;
  order.reserve(tree.members.size());
  visit_nodes(tree, eye, [&](const BspNode& node) {
    for (std::uint32_t m = node.first + node.count; m-- > node.first;)
      order.push_back(tree.members[m]);
  });
  return order;
}

std::vector<std::uint32_t> front_to_back(const BspTree& tree, const Vec3& eye) {
  std::vector<std::uint32_t> order = back_to_front(tree, eye);
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<std::uint32_t> visibility_priorities(const BspTree& tree, const Vec3& eye) {
  std::vector<std::uint32_t> priority(tree.members.size());
  std::uint32_t next = 0;
  visit_nodes(tree, eye, [&](const BspNode& node) {
    for (std::uint32_t m = node.first + node.count; m-- > node.first;) priority[m] = ++next;
  });
  return priority;
}

}  // namespace cigsim
