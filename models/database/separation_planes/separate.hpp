// SPDX-License-Identifier: MIT
// Stump's separation program improved: exact sides, no operator, fewest planes, and a proof.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/database/listability/listability.hpp"
#include "models/database/separation_planes/divider.hpp"
#include "models/environment/deck.hpp"

namespace cigsim::separation_planes {

struct SeparateOptions {
  std::uint64_t most_steps = 300000;  ///< of each search for fewest planes
  /// Planes through three corners that are looked at, at most, so that the least number holds over
  /// all planes. 16 boxes have 341,376.
  std::uint64_t most_corner_planes = 350000;
};

/// A plane of the table. Numbers of objects are those of SeparationResult::bodies, from 1.
struct ResultPlane {
  Plane plane;
  Origin origin;
  std::vector<ObjectPair> pairs;
};

/// An object that was split. Its part on the FALSE side of the plane keeps its number.
struct ResultSplit {
  std::uint32_t object = 0, true_part = 0;
  std::uint32_t plane = 0;  ///< of the table, from 1
};

/// What is known of the least number of planes.
struct LeastPlanes {
  std::uint32_t any_table = 0;   ///< no table of any kind has fewer
  std::uint32_t division = 0;    ///< no table that divides sets in two has fewer
  bool all_planes = false;       ///< over all planes there are; else over faces and S cards
  bool by_pockets = false;       ///< any_table: each object needs a pocket of its own
  std::uint64_t candidates = 0;  ///< planes that were looked at, and of them
  std::uint64_t different = 0;   ///< those that divide objects in a way of their own
};

struct SeparationResult {
  std::vector<Body> bodies;  ///< objects 1, 2, …; parts of split ones after them
  std::vector<ResultPlane> planes;
  std::vector<ResultSplit> splits;
  bool pair_by_pair = false;
  std::optional<std::uint32_t> published;  ///< planes by the published rule; none: it finds none
  std::uint32_t greedy = 0;                ///< planes by the exact rule, without search
  std::optional<LeastPlanes> least;  ///< none: more than 64 objects, or objects were split, or a
                                     ///< set has planes a pair
  listability::Proof proof;
};

/// Throws NotApart and NotToBeSplit.
SeparationResult separate(const StumpDeck& deck, const SeparateOptions& options = {});

}  // namespace cigsim::separation_planes
