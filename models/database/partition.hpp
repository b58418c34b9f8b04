// SPDX-License-Identifier: MIT
// The separation tree: planes that part the items two and two down to single ones, cutting items
// only where no plane found parts a set.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "models/database/detail/composite.hpp"
#include "models/database/work_set.hpp"

namespace cigsim {

/// A child >= 0 is a node, a child < 0 is the leaf ~child.
struct PartitionNode {
  std::uint32_t plane = 0;  ///< into Partition::planes; TRUE is the side of its normal
  std::int32_t true_child = 0, false_child = 0;
};

/// A leaf where a choice stands, with the subtrees of its descriptions.
struct ChoiceLeaf {
  std::uint32_t leaf = 0;  ///< without items of its own
  std::uint32_t choice = 0;
  std::vector<std::optional<std::int32_t>> roots;  ///< none: the description has nothing here
};

struct Partition {
  std::vector<Plane> planes;
  std::vector<PartitionNode> nodes;  ///< children come after their parents
  std::int32_t root = -1;            ///< as a child; of a partition of anything
  /// Items of a leaf: one patch, or coplanar polygons, the first of highest priority.
  std::vector<std::vector<std::uint32_t>> leaves;
  std::vector<ChoiceLeaf> choices;  ///< ascending by leaf
  /// Choices of which only the most detailed description is kept, because no plane parts all from
  /// other items, or because others share a plane with them.
  std::vector<std::uint32_t> given_up;
  std::uint64_t cuts = 0;
  std::uint64_t tolerated = 0;  ///< times that an item within the contact tolerance was not cut
};

/// Partitions all items of the set; cuts append to it. `progress` gets the items done and all
/// items.
Partition partition(WorkSet& set,
                    const std::function<void(std::uint64_t, std::uint64_t)>& progress);

/// Partitions `items`, some of them composites, and what their descriptions hold. When a choice
/// that was cut (composites.was_cut()) is given up, other parts of it may still stand as choices:
/// the caller must start again without it.
Partition partition(WorkSet& set, Composites& composites, std::vector<std::uint32_t> items,
                    const std::function<void(std::uint64_t, std::uint64_t)>& progress);

}  // namespace cigsim
