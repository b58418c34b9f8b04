// SPDX-License-Identifier: MIT
// A listable table for a few objects that no plane divides in two sets: every pair on a plane of
// its own choice, so that no three objects ever form a circuit (listability.hpp, claim 2). Planes
// through one line can do that: three wedges around an axis are listable whole.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "models/database/separation_planes/candidates.hpp"

namespace cigsim::separation_planes {

/// Objects at most.
inline constexpr std::size_t kMostPairByPair = 6;

/// Two bodies that a candidate parts: `on_true` lies whole on its TRUE side, `on_false` on the
/// other.
struct PartedPair {
  std::uint32_t candidate = 0, on_true = 0, on_false = 0;
};

/// A candidate for every pair of the set, or nothing when there is no listable choice among the
/// first candidates of each pair (or the search grows too long).
std::optional<std::vector<PartedPair>> pair_by_pair(const SideTable& table,
                                                    std::span<const std::uint32_t> set);

}  // namespace cigsim::separation_planes
