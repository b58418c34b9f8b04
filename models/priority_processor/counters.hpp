// SPDX-License-Identifier: MIT
// Priority by counters (Stump 1986, ch. III): for each plane and each TRUE/FALSE pair of members on
// it, the member on the side opposite the eyepoint is incremented. Count 0 is the highest priority;
// counts that are not unique are a listability fault.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "models/priority_processor/group_order.hpp"

namespace cigsim::priority_processor {

/// The counters of the active members; zero for the others. `eye_true`: bit n is set when the
/// eyepoint is on the TRUE side of node n's plane. `pairs`: those of the hierarchy.
inline std::array<std::uint8_t, kGroupCapacity> counters(std::span<const SeparationNode> nodes,
                                                         std::uint64_t eye_true,
                                                         std::uint64_t active,
                                                         std::span<const MemberPair> pairs = {}) {
  std::array<std::uint8_t, kGroupCapacity> counts{};
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const bool eye = (eye_true >> n) & 1;
    if (nodes[n].pair_count > 0) {
      for (const auto [t, f] : pairs.subspan(nodes[n].first_pair, nodes[n].pair_count))
        if ((active >> t & 1) && (active >> f & 1)) ++counts[eye ? f : t];
      continue;
    }
    const std::uint64_t near_side = active & (eye ? nodes[n].true_members : nodes[n].false_members);
    const std::uint64_t far_side = active & (eye ? nodes[n].false_members : nodes[n].true_members);
    // Each far member is in one pair with each near member.
    const auto nearer = static_cast<std::uint8_t>(std::popcount(near_side));
    for (std::uint64_t rest = far_side; rest != 0; rest &= rest - 1)
      counts[std::countr_zero(rest)] =
          static_cast<std::uint8_t>(counts[std::countr_zero(rest)] + nearer);
  }
  return counts;
}

inline void order_by_counters(std::span<const SeparationNode> nodes, std::uint64_t eye_true,
                              std::uint64_t active, GroupOrder& out,
                              std::span<const MemberPair> pairs = {}) {
  list_by_count(active, counters(nodes, eye_true, active, pairs), out);
}

}  // namespace cigsim::priority_processor
