// SPDX-License-Identifier: MIT
// Rule 2 of Fuchs, Kedem, Naylor 1980: the root that eliminates most polygon conflicts.
//
// Two polygons are in conflict when the plane of one intersects the other: f(s, t) = 1 where the
// plane of s splits t (touching it does not count: such a polygon is never cut). For a root p, S1
// and S3 are the polygons wholly on its positive and its negative side, S2 those that it splits;
// I(m, n) is the sum of f over S_m x S_n. Conflicts across the root, I(1,3) + I(3,1), can never
// cause a split again; those among the polygons that it splits, I(2,2), may occur twice from now
// on.
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/work_set.hpp"

namespace cigsim {

struct ConflictCounts {
  std::uint64_t front_back = 0;   ///< I(1,3): planes of the positive side, polygons of the negative
  std::uint64_t back_front = 0;   ///< I(3,1)
  std::uint64_t split_split = 0;  ///< I(2,2)

  double value(double weight) const {
    return static_cast<double>(front_back + back_front) - weight * static_cast<double>(split_split);
  }
};

/// The counts of each polygon of the list as root; n^2 side tests and n^3 / 64 steps.
std::vector<ConflictCounts> count_conflicts(const WorkSet& set,
                                            const std::vector<std::uint32_t>& items);

/// The place in `items` (not empty) of the root with the largest value; the first of equal ones.
std::size_t best_by_conflicts(const WorkSet& set, const std::vector<std::uint32_t>& items,
                              double weight);

}  // namespace cigsim
