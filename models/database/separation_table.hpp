// SPDX-License-Identifier: MIT
// Priority data made by hand: separation planes with TRUE/FALSE pairs (Stump 1986, ch. III), as the
// one group of a hierarchy. Whether the table is listable from everywhere is its maker's business;
// the priority processor finds out.
#pragma once

#include <string>

#include "models/database/database.hpp"
#include "models/database/work_set.hpp"

namespace cigsim {

inline constexpr std::uint32_t kTablePlanes = kGroupCapacity - 1;  ///< of a table, at most

/// Throws InputError when the environment's objects or its table cannot make one group: their
/// number, pairs without an object, moving systems. `file` stands for the scene in messages.
void check_table(const Environment& environment, const std::string& file);

/// The group of all items: item k of `work` and of `set` is object k + 1, whole and convex. Throws
/// InputError, naming object and plane, when an object lies not on the side that its pair says.
PriorityHierarchy table_hierarchy(const Environment& environment, const WorkSet& work,
                                  const FaceSet& set, const std::string& file);

}  // namespace cigsim
