// SPDX-License-Identifier: MIT
// From a separation tree to groups of at most 64 members with their planes and pairs.
#pragma once

#include <span>

#include "models/database/database.hpp"
#include "models/database/partition.hpp"

namespace cigsim {

/// Groups are cut from the tree from its leaves, each at least half full but the root and those of
/// choices and their descriptions. Leaves without a choice are the items of the set, in their
/// order; the set's further items are placeholders, one a description that has nothing in a
/// choice's leaf. Group::choice is ChoiceLeaf::choice; PriorityHierarchy::choices is left to the
/// caller.
PriorityHierarchy build_hierarchy(const Partition& partition, const FaceSet& set);

/// The item of each leaf; kNone: a choice stands there.
std::vector<std::uint32_t> items_of_leaves(const Partition& partition);

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
