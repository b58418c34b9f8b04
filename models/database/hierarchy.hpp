// SPDX-License-Identifier: MIT
// From a separation tree to groups of at most 64 members with their planes and pairs.
#pragma once

#include <span>

#include "models/database/database.hpp"
#include "models/database/partition.hpp"

namespace cigsim {

/// Leaf k of the tree is item k of the set. Groups are cut from the
/// tree from its leaves, each at least half full but the root.
PriorityHierarchy build_hierarchy(const Partition& partition, const FaceSet& set);

/// A sphere around spheres, grown to cover rounding.
Sphere enclosing(const std::vector<Sphere>& spheres);

/// A sphere around points, grown to cover rounding.
Sphere enclosing(std::span<const Vec3> points);

/// TRUE/FALSE pairs over all groups.
std::uint64_t pair_count(const PriorityHierarchy& hierarchy);

/// Nodes on the longest way from the root to a member, over all groups. All nodes of a table made
/// by hand are on every way.
std::uint64_t depth(const PriorityHierarchy& hierarchy);

}  // namespace cigsim
