// SPDX-License-Identifier: MIT
// Partition of a coordinate system whose objects belong to choices (Levine 1975, ch. II.G).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "models/database/database.hpp"
#include "models/database/partition.hpp"

namespace cigsim {

/// The items of an object in the working set: [first, end).
struct ItemRange {
  std::uint32_t first = 0, end = 0;
};

struct DetailPartition {
  WorkSet work;
  Partition tree;
  std::vector<PreparedChoice> choices;  ///< by Environment::choices; those that stand
  std::uint64_t given_up = 0;           ///< choices of which the most detailed description stands
  std::uint64_t without_detail = 0;     ///< choices left out: the most detailed has no face
};

/// `objects` are all of the environment's, those of other systems without items. Where a plane must
/// part a choice from other items, all descriptions are cut along; where that would not be right,
/// the most detailed description takes the choice's place throughout.
DetailPartition partition_with_choices(
    const Environment& environment, const WorkSet& work, const std::vector<ItemRange>& objects,
    const std::function<void(std::uint64_t, std::uint64_t)>& progress);

/// Gives the hierarchy those of `choices` that its groups name, in their order.
void take_choices(const std::vector<PreparedChoice>& choices, PriorityHierarchy& hierarchy);

}  // namespace cigsim
