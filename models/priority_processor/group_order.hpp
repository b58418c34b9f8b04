// SPDX-License-Identifier: MIT
// The order of one group's active members from the sides of its planes. Two methods stand behind
// this one interface: counters.hpp and so_matrix.hpp.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "models/database/database.hpp"

namespace cigsim::priority_processor {

enum class Method {
  kCounters,  ///< Stump 1986: a counter per object over TRUE/FALSE pairs
  kSoMatrix   ///< Levine 1975, ch. VI.E: the separating-object bit matrix
};

struct GroupOrder {
  std::array<std::uint8_t, kGroupCapacity> member{};  ///< by count, 0 = highest priority
  std::uint32_t count = 0;
  bool unique = true;  ///< false: a listability fault
};

/// Puts members in the order of their counts and checks that the counts are a permutation of
/// 0 .. n-1. At a fault the members stay in the order of count, then number, so that a picture
/// still comes out.
inline void list_by_count(std::uint64_t active,
                          const std::array<std::uint8_t, kGroupCapacity>& counts, GroupOrder& out) {
  out.count = static_cast<std::uint32_t>(std::popcount(active));
  std::uint64_t seen = 0;
  for (std::uint64_t rest = active; rest != 0; rest &= rest - 1) {
    const int m = std::countr_zero(rest);
    seen |= std::uint64_t{1} << counts[m];
    out.member[counts[m]] = static_cast<std::uint8_t>(m);
  }
  const std::uint64_t all =
      out.count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << out.count) - 1;
  out.unique = seen == all;
  if (out.unique) return;
  std::uint32_t place = 0;
  for (std::uint32_t c = 0; c < kGroupCapacity; ++c)
    for (std::uint64_t rest = active; rest != 0; rest &= rest - 1)
      if (counts[std::countr_zero(rest)] == c)
        out.member[place++] = static_cast<std::uint8_t>(std::countr_zero(rest));
}

}  // namespace cigsim::priority_processor
