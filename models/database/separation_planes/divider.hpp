// SPDX-License-Identifier: MIT
// Dividing a set of objects in two, and again, without an operator.
//
// As Stump's program does (published.hpp), with exact sides. Of the candidates that divide a set it
// takes one that is chosen already, if there is one; else the one with the least difference between
// the two sides; else the one that divides most pairs of the sets still waiting; else the one that
// cuts fewest objects; else the first. Where no candidate divides a set, in this order:
//  1. planes that contain an edge of one object and are parallel to an edge of another, then planes
//     through three corners (through any three: if none of them divides the set, no plane does);
//  2. a plane of its own for every pair (pair_by_pair.hpp), for a few objects;
//  3. a split: the candidate that parts two objects of the set and cuts fewest of the others. The
//     two parts of what it cuts go on as objects of their own. Each split parts two objects for
//     good, so this comes to an end.
#pragma once

#include <stdexcept>
#include <vector>

#include "models/database/separation_planes/pair_by_pair.hpp"

namespace cigsim::separation_planes {

/// A body that was split: its FALSE part keeps its number, its TRUE part is a new body.
struct Split {
  std::uint32_t body = 0, new_body = 0, candidate = 0;
};

/// Two objects that no plane parts, whole or not: they reach into each other.
class NotApart : public std::runtime_error {
 public:
  NotApart(std::uint32_t object_a, std::uint32_t object_b);
};

/// An object that would have to be split but is no closed convex body.
class NotToBeSplit : public std::runtime_error {
 public:
  explicit NotToBeSplit(std::uint32_t object);
};

struct DividedTable {
  std::vector<PartedPair> pairs;  ///< of bodies, each two once; in the order of the division
  std::vector<Split> splits;
  std::uint32_t planes = 0;   ///< different candidates
  bool pair_by_pair = false;  ///< some set has planes a pair
};

/// Divides all bodies of the table, which gets the further candidates and the parts of what is
/// split. Throws NotApart and NotToBeSplit.
DividedTable divide(SideTable& table);

}  // namespace cigsim::separation_planes
