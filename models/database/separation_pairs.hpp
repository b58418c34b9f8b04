// SPDX-License-Identifier: MIT
// The members of a group in a mask, and the TRUE/FALSE pairs that a separation node resolves
// (Stump 1986, ch. III).
#pragma once

#include <bit>
#include <cstdint>

#include "models/database/database.hpp"

namespace cigsim {

/// Calls visit(member) for each bit of a mask of members, ascending.
template <class Visit>
void for_each_member(std::uint64_t members, Visit&& visit) {
  for (; members != 0; members &= members - 1)
    visit(static_cast<std::uint32_t>(std::countr_zero(members)));
}

/// Calls visit(true_member, false_member) for each pair of a node: those that a table made by hand
/// lists, else every TRUE member with every FALSE member.
template <class Visit>
void for_each_pair(const PriorityHierarchy& hierarchy, const SeparationNode& node, Visit&& visit) {
  for (std::uint32_t p = node.first_pair; p < node.first_pair + node.pair_count; ++p)
    visit(std::uint32_t{hierarchy.pairs[p].true_member},
          std::uint32_t{hierarchy.pairs[p].false_member});
  if (node.pair_count > 0) return;
  for_each_member(node.true_members, [&](std::uint32_t t) {
    for_each_member(node.false_members, [&](std::uint32_t f) { visit(t, f); });
  });
}

}  // namespace cigsim
