// SPDX-License-Identifier: MIT
// The least number of planes of a table, by search.
//
// A table is a *division* when it comes from dividing sets of objects in two by planes that cut
// none of the set, down to single objects, as Stump's program does (1986, ch. III): every division
// is listable. What matters of a plane then is only which objects lie whole on its TRUE and on its
// FALSE side. Planes may be chosen for one set and used for others too, so the search branches over
// the planes that divide one set which no chosen plane divides. Nothing is lost by using chosen
// planes first: a plane set that divides a set also divides every part of it.
//
// Lower bounds, for tables of any kind, divisions or not:
//  - pockets: k planes make at most 1 + k + C(k,2) + C(k,3) pockets, and each object needs one of
//    its own;
//  - pairs: every pair of objects must be parted by some plane. The least number of planes that
//    part all pairs is found by search too.
//
// With the planes through every three corners as candidates this holds for all planes there are:
// the planes that have these objects on one closed side and those on the other form a cone in
// (n, d), pointed because an object fills space, and its extreme rays pass through three corners
// not on one line.
#pragma once

#include <cstdint>
#include <vector>

namespace cigsim::separation_planes {

/// The objects that lie whole on the two sides of a plane, a bit each: at most 64 objects.
struct SidePair {
  std::uint64_t on_true = 0, on_false = 0;
  friend bool operator==(const SidePair&, const SidePair&) = default;
};

/// Turned so that the least object is on the TRUE side.
SidePair turned(const SidePair& plane);

/// Those that no other one contains, side for side, each once (turned).
std::vector<SidePair> maximal(std::vector<SidePair> planes);

struct Fewest {
  std::vector<std::uint32_t> planes;  ///< of a division with fewer than `upper` planes; or none
  std::uint32_t any_table = 0;        ///< no table of any kind has fewer
  std::uint32_t division = 0;         ///< no division has fewer
  bool by_pockets = false;            ///< any_table is the bound by pockets
  std::uint64_t steps = 0;
};

/// The least k with 1 + k + C(k,2) + C(k,3) pockets for n objects.
std::uint32_t planes_for_pockets(std::uint64_t objects);

/// A division of n objects (2 to 64) with fewer than `upper` planes, if there is one among the
/// candidates, the fewest first. Ends after `most_steps` with the bounds reached so far.
Fewest fewest_planes(std::uint32_t objects, const std::vector<SidePair>& candidates,
                     std::uint32_t upper, std::uint64_t most_steps);

}  // namespace cigsim::separation_planes
