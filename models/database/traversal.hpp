// SPDX-License-Identifier: MIT
// Reading a separation tree from an eyepoint (Fuchs, Kedem, Naylor 1980: the eye's side, then the
// other side).
#pragma once

#include "models/database/database.hpp"
#include "models/database/partition.hpp"

namespace cigsim {

/// The place of each item in the order from front to back, all items active.
std::vector<std::uint32_t> ranks_from(const PriorityHierarchy& hierarchy, std::size_t item_count,
                                      const Vec3& eye);

/// Leaves from front to back.
std::vector<std::uint32_t> leaves_from(const Partition& partition, const Vec3& eye);

}  // namespace cigsim
