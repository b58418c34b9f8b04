// SPDX-License-Identifier: MIT
#include "models/database/listability/group_listability.hpp"

#include <algorithm>
#include <cmath>

#include "models/database/separation_pairs.hpp"

namespace cigsim::listability {
namespace {

class SideChecker {
 public:
  SideChecker(const PriorityHierarchy& hierarchy, const FaceSet& set, double contact_tolerance,
              std::size_t most)
      : hierarchy_(hierarchy), set_(set), tolerance_(contact_tolerance), most_(most) {}

  SideCheck run() {
    for (std::uint32_t g = 0; g < hierarchy_.groups.size(); ++g) {
      const Group& group = hierarchy_.groups[g];
      for (std::uint32_t n = 0; n < group.node_count; ++n) {
        const SeparationNode& node = hierarchy_.nodes[group.first_node + n];
        for_each_member(node.true_members, [&](std::uint32_t m) { member(g, n, m, true); });
        for_each_member(node.false_members, [&](std::uint32_t m) { member(g, n, m, false); });
      }
    }
    return std::move(check_);
  }

 private:
  void member(std::uint32_t group, std::uint32_t node, std::uint32_t m, bool true_side) {
    open_.assign(1, hierarchy_.groups[group].first_member + m);
    while (!open_.empty()) {
      const Member& at = hierarchy_.members[open_.back()];
      open_.pop_back();
      if (!at.is_group) {
        item(group, node, at.index, true_side);
        continue;
      }
      const Group& below = hierarchy_.groups[at.index];
      for (std::uint32_t k = 0; k < below.member_count; ++k)
        open_.push_back(below.first_member + k);
    }
  }

  void item(std::uint32_t group, std::uint32_t node, std::uint32_t index, bool true_side) {
    ++check_.tests;
    const Plane& plane =
        hierarchy_.planes[hierarchy_.nodes[hierarchy_.groups[group].first_node + node].plane];
    const Item& item = set_.items[index];
    bool across = false;
    for (std::uint32_t v = item.first_vertex; v < item.first_vertex + item.vertex_count; ++v)
      across = across || side_of(plane, v) == (true_side ? -1 : 1);
    if (!across) return;
    const auto [wrong, right, largest] = depths(plane, item, true_side);
    if (right > wrong && wrong <= std::min(tolerance_ * largest, 0x1p-16 * right)) {
      ++check_.tolerated;
      check_.deepest = std::max(check_.deepest, wrong);
      return;
    }
    ++check_.fault_count;
    if (check_.faults.size() < most_)
      check_.faults.push_back({group, node, index, true_side, wrong});
  }

  int side_of(const Plane& plane, std::uint32_t v) const {
    const ExactVec* exact = set_.exact(v);
    return exact ? side(plane, set_.vertices[v], *exact) : side(plane, set_.vertices[v]);
  }

  struct Depths {
    double wrong = 0, right = 0, largest = 0;
  };
  Depths depths(const Plane& plane, const Item& item, bool true_side) const {
    Depths out;
    const double length = std::hypot(plane.normal.x, plane.normal.y, plane.normal.z);
    for (std::uint32_t v = item.first_vertex; v < item.first_vertex + item.vertex_count; ++v) {
      const Vec3& p = set_.vertices[v];
      const double value = dot(plane.normal, p - plane.exact.p) / length;
      const double right = true_side ? value : -value;
      out.right = std::max(out.right, right);
      out.wrong = std::max(out.wrong, -right);
      out.largest = std::max({out.largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    return out;
  }

  const PriorityHierarchy& hierarchy_;
  const FaceSet& set_;
  double tolerance_;
  std::size_t most_;
  std::vector<std::uint32_t> open_;
  SideCheck check_;
};

}  // namespace

PriorityTable table_of_group(const PriorityHierarchy& hierarchy, std::uint32_t group) {
  const Group& g = hierarchy.groups[group];
  PriorityTable table;
  table.members = g.member_count;
  for (std::uint32_t n = 0; n < g.node_count; ++n) {
    const SeparationNode& node = hierarchy.nodes[g.first_node + n];
    table.planes.push_back(hierarchy.planes[node.plane]);
    for_each_pair(hierarchy, node, [&](std::uint32_t t, std::uint32_t f) {
      table.pairs.push_back({n, t, f});
    });
  }
  return table;
}

SideCheck check_sides(const PriorityHierarchy& hierarchy, const FaceSet& set,
                      double contact_tolerance, std::size_t most) {
  return SideChecker(hierarchy, set, contact_tolerance, most).run();
}

}  // namespace cigsim::listability
