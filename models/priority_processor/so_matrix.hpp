// SPDX-License-Identifier: MIT
// Priority by the separating-object matrix (Levine 1975, ch. VI.E). SEPL has a row a member and a
// column a plane: +, - or nothing where the plane does not part the member from others. A row is
// two words: whether the plane tells of the member (S), and whether the member is on the eye's side
// (R, zero where S is zero).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "models/priority_processor/group_order.hpp"

namespace cigsim::priority_processor {

/// A row of SEPL marked for an eyepoint.
struct SeplRow {
  std::uint64_t r = 0, s = 0;
};

enum class Separation : std::int8_t {
  kHides = 1,       ///< the first may hide the second
  kHidden = -1,     ///< the second may hide the first
  kNeither = 0,     ///< planes on both sides: neither can hide the other
  kUnresolved = 2,  ///< no plane parts the two (the source reads this as "neither")
};

/// SO(l, m). Where only RR_m is nonzero the answer is -1 (the source prints 1; its example has -1).
inline Separation separating_object(const SeplRow& l, const SeplRow& m) {
  const std::uint64_t both = l.s & m.s, differ = (l.r ^ m.r) & both;
  const bool l_nearer = (l.r & differ) != 0, m_nearer = (m.r & differ) != 0;
  if (l_nearer && m_nearer) return Separation::kNeither;
  if (l_nearer) return Separation::kHides;
  return m_nearer ? Separation::kHidden : Separation::kUnresolved;
}

/// Marks SEPL for an eyepoint. Bit n of a row belongs to node n.
inline std::array<SeplRow, kGroupCapacity> marked_sepl(std::span<const SeparationNode> nodes,
                                                       std::uint64_t eye_true) {
  std::array<SeplRow, kGroupCapacity> rows{};
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const std::uint64_t column = std::uint64_t{1} << n;
    const bool eye = (eye_true >> n) & 1;
    const std::uint64_t near_side = eye ? nodes[n].true_members : nodes[n].false_members;
    for (std::uint64_t rest = nodes[n].true_members | nodes[n].false_members; rest != 0;
         rest &= rest - 1)
      rows[std::countr_zero(rest)].s |= column;
    for (std::uint64_t rest = near_side; rest != 0; rest &= rest - 1)
      rows[std::countr_zero(rest)].r |= column;
  }
  return rows;
}

/// A member's count is the number of members that may hide it; a pair without an answer leaves the
/// counts not unique. In a table made by hand a pair is asked about the planes that list it, and no
/// others: what its maker left out, or gave to the wrong plane, must not be mended here.
inline void order_by_so_matrix(std::span<const SeparationNode> nodes, std::uint64_t eye_true,
                               std::uint64_t active, GroupOrder& out,
                               std::span<const MemberPair> pairs = {}) {
  const auto rows = marked_sepl(nodes, eye_true);
  std::array<std::uint8_t, kGroupCapacity> counts{};
  if (!nodes.empty() && nodes[0].pair_count > 0) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const std::uint64_t column = std::uint64_t{1} << n;
      for (const auto [t, f] : pairs.subspan(nodes[n].first_pair, nodes[n].pair_count)) {
        if (!(active >> t & 1) || !(active >> f & 1)) continue;
        const Separation so = separating_object({rows[t].r & column, rows[t].s & column},
                                                {rows[f].r & column, rows[f].s & column});
        ++counts[so == Separation::kHides ? f : t];
      }
    }
    list_by_count(active, counts, out);
    return;
  }
  for (std::uint64_t rest_l = active; rest_l != 0; rest_l &= rest_l - 1) {
    const int l = std::countr_zero(rest_l);
    for (std::uint64_t rest_m = rest_l & (rest_l - 1); rest_m != 0; rest_m &= rest_m - 1) {
      const int m = std::countr_zero(rest_m);
      const Separation so = separating_object(rows[l], rows[m]);
      counts[m] = static_cast<std::uint8_t>(counts[m] + (so == Separation::kHides));
      counts[l] = static_cast<std::uint8_t>(counts[l] + (so == Separation::kHidden));
    }
  }
  list_by_count(active, counts, out);
}

}  // namespace cigsim::priority_processor
