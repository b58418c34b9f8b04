// SPDX-License-Identifier: MIT
// Priority processor, functional level (Stump 1986, ch. II and III): from the eyepoint and the
// active groups to one list of items, group by group from the root; then the moving pieces at their
// places, and the ground last ("objects always have priority over the ground").
#pragma once

#include <algorithm>
#include <limits>

#include "models/boundary/transactions.hpp"
#include "models/priority_processor/circuit.hpp"
#include "models/priority_processor/counters.hpp"
#include "models/priority_processor/eye_side.hpp"
#include "models/priority_processor/kept_orders.hpp"
#include "models/priority_processor/so_matrix.hpp"

namespace cigsim::priority_processor {

template <class N>
class Functional {
 public:
  /// `coherent`: orders are kept from frame to frame, and every compute() is for one and the same
  /// hierarchy. The lists are the same either way.
  explicit Functional(Method method, bool coherent = false)
      : method_(method), coherent_(coherent) {}

  /// `objects`: the set of the hierarchy's items, which names the objects of a fault.
  void compute(const PriorityHierarchy& hierarchy, const FaceSet& objects,
               const ActiveEnvironment& active, const FaceSet& ground, PriorityList& out) {
    out.items.clear();
    out.faults.clear();
    work_ = {};
    order_.resize(active.groups.size());
    for (std::size_t g = 0; g < active.groups.size(); ++g) {
      const ActiveGroup& group = active.groups[g];
      const std::uint64_t eye_true = order_group(hierarchy, group, active.view.eye, order_[g]);
      if (!order_[g].unique)
        out.faults.push_back(
            listability_fault(hierarchy, objects, group.group, group.active, eye_true));
    }
    if (active.groups.empty())
      for (const auto& piece : active.moving) out.items.push_back({SetId::kMoving, piece.item});
    else
      list_items(hierarchy, active, out);
    for (std::uint32_t i = 0; i < ground.items.size(); ++i)
      out.items.push_back({SetId::kGround, i});
  }

  /// Of the last frame.
  const OrderingWork& work() const { return work_; }

 private:
  // Returns the nodes on whose TRUE side the eyepoint is.
  std::uint64_t order_group(const PriorityHierarchy& hierarchy, const ActiveGroup& active,
                            const Vec3& eye, GroupOrder& out) {
    if (std::popcount(active.active) < 2) {  // nothing to order
      list_by_count(active.active, {}, out);
      return 0;
    }
    if (coherent_) return order_coherently(hierarchy, active, eye, out);
    const std::uint64_t eye_true = test_planes(
        hierarchy, active, [&](const Plane& plane) { return eye_on_true_side<N>(plane, eye); });
    count_members(hierarchy, active, eye_true, out);
    return eye_true;
  }

  // The same from what was kept, where that is certain.
  std::uint64_t order_coherently(const PriorityHierarchy& hierarchy, const ActiveGroup& active,
                                 const Vec3& eye, GroupOrder& out) {
    KeptOrder& kept = kept_.of(active.group, hierarchy.groups.size());
    bool stands = kept.active == active.active;
    if (!stands || !kept.stands_at(eye)) {
      double least = std::numeric_limits<double>::infinity();
      const std::uint64_t eye_true = test_planes(hierarchy, active, [&](const Plane& plane) {
        double clearance = 0;
        const bool is_true = eye_on_true_side<N>(plane, eye, clearance);
        least = std::min(least, clearance);
        return is_true;
      });
      stands = stands && kept.eye_true == eye_true;
      if (!stands) count_members(hierarchy, active, eye_true, kept.order);
      kept.active = active.active;
      kept.eye_true = eye_true;
      kept.set_eye(eye, least);
    }
    work_.reused_groups += stands;
    out = kept.order;
    return kept.eye_true;
  }

  // Nodes whose planes part active members, and have the eyepoint on the TRUE side.
  template <class IsTrue>
  std::uint64_t test_planes(const PriorityHierarchy& hierarchy, const ActiveGroup& active,
                            IsTrue is_true) {
    const std::span<const SeparationNode> nodes = nodes_of(hierarchy, active);
    std::uint64_t eye_true = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      // A plane with active members on one side only resolves nothing in this frame.
      if (!(nodes[n].true_members & active.active) || !(nodes[n].false_members & active.active))
        continue;
      ++work_.tested_planes;
      if (is_true(hierarchy.planes[nodes[n].plane])) eye_true |= std::uint64_t{1} << n;
    }
    return eye_true;
  }

  void count_members(const PriorityHierarchy& hierarchy, const ActiveGroup& active,
                     std::uint64_t eye_true, GroupOrder& out) {
    const std::span<const SeparationNode> nodes = nodes_of(hierarchy, active);
    ++work_.ordered_groups;
    if (method_ == Method::kCounters)
      order_by_counters(nodes, eye_true, active.active, out, hierarchy.pairs);
    else
      order_by_so_matrix(nodes, eye_true, active.active, out, hierarchy.pairs);
  }

  static std::span<const SeparationNode> nodes_of(const PriorityHierarchy& hierarchy,
                                                  const ActiveGroup& active) {
    const Group& group = hierarchy.groups[active.group];
    return {hierarchy.nodes.data() + group.first_node, group.node_count};
  }

  // Opens the groups in order of priority.
  void list_items(const PriorityHierarchy& hierarchy, const ActiveEnvironment& active,
                  PriorityList& out) {
    struct Place {
      std::uint32_t group, next;
    };
    std::vector<Place> stack{{0, 0}};
    while (!stack.empty()) {
      Place& at = stack.back();
      const GroupOrder& order = order_[at.group];
      if (at.next == order.count) {
        stack.pop_back();
        continue;
      }
      const ActiveGroup& group = active.groups[at.group];
      const std::uint32_t m = order.member[at.next++];
      const std::uint32_t first = hierarchy.groups[group.group].first_member;
      const Member& member = hierarchy.members[first + m];
      if (member.is_group) {
        std::uint32_t child = group.first_child;
        for (std::uint64_t below = group.active & ((std::uint64_t{1} << m) - 1); below != 0;
             below &= below - 1)
          child += hierarchy.members[first + static_cast<std::uint32_t>(std::countr_zero(below))]
                       .is_group;
        stack.push_back({child, 0});
      } else {
        list_with_pieces(member, active, out);
      }
    }
  }

  void list_with_pieces(const Member& member, const ActiveEnvironment& active, PriorityList& out) {
    const std::uint32_t item = member.index;
    const auto& moving = active.moving;
    auto piece = std::lower_bound(moving.begin(), moving.end(), item,
                                  [](const auto& p, std::uint32_t i) { return p.neighbour < i; });
    for (; piece != moving.end() && piece->neighbour == item && piece->before; ++piece)
      out.items.push_back({SetId::kMoving, piece->item});
    if (!member.placeholder) out.items.push_back({SetId::kStatic, item});
    for (; piece != moving.end() && piece->neighbour == item; ++piece)
      out.items.push_back({SetId::kMoving, piece->item});
  }

  Method method_;
  bool coherent_;
  OrderingWork work_;
  KeptOrders kept_;
  std::vector<GroupOrder> order_;
};

}  // namespace cigsim::priority_processor
