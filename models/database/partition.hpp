// SPDX-License-Identifier: MIT
// The separation tree: planes that part the items two and two down to single ones, cutting items
// only where no plane found parts a set.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "models/database/work_set.hpp"

namespace cigsim {

/// A child >= 0 is a node, a child < 0 is the leaf ~child.
struct PartitionNode {
  std::uint32_t plane = 0;  ///< into Partition::planes; TRUE is the side of its normal
  std::int32_t true_child = 0, false_child = 0;
};

struct Partition {
  std::vector<Plane> planes;
  std::vector<PartitionNode> nodes;  ///< [0] is the root, when there are two leaves or more
  /// Items of a leaf: one patch, or coplanar polygons, the first of highest priority.
  std::vector<std::vector<std::uint32_t>> leaves;
  std::uint64_t cuts = 0;
  std::uint64_t tolerated = 0;  ///< times that an item within the contact tolerance was not cut
};

/// Partitions all items of the set; cuts append to it. `progress` gets the items done and all
/// items.
Partition partition(WorkSet& set,
                    const std::function<void(std::uint64_t, std::uint64_t)>& progress);

}  // namespace cigsim
