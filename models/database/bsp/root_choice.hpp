// SPDX-License-Identifier: MIT
// Which polygon's plane becomes the root of a (sub)tree: the two rules of Fuchs, Kedem, Naylor
// 1980, the order of the scene, and a rule of our own for large scenes.
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/work_set.hpp"
#include "models/environment/random.hpp"

namespace cigsim {

enum class BspRule {
  kFirst,         ///< the first in the order of the scene (the source's "arbitrary" choice)
  kFewestSplits,  ///< rule 1: the plane that splits the fewest polygons
  kConflicts,     ///< rule 2: the largest I(1,3) + I(3,1) - weight I(2,2), conflicts eliminated
  kCost           ///< ours: splits, and the growth that is to be expected of both parts
};

struct RootOptions {
  BspRule rule = BspRule::kCost;
  double weight = 1;  ///< of rule 2
  /// At most so many polygons of a list, drawn at random from a longer one, are tried as root;
  /// rule 2 counts conflicts among these alone. 0: the rule's own number, 128 (rules 1 and 2)
  /// or 64.
  std::uint32_t candidates = 0;
  std::uint64_t seed = 1;  ///< of the draws
  /// Rule kCost may also take planes across the axes, which hold no polygon (the source's hybrid
  /// of polygons and dividing planes).
  bool dividing_planes = true;
};

/// How the polygons of a list lie about a plane. A polygon that only touches it is on the side of
/// its body.
struct SideCounts {
  std::uint64_t positive = 0, negative = 0, in_plane = 0, split = 0;
};

class RootChooser {
 public:
  RootChooser(WorkSet& set, const RootOptions& options)
      : set_(set), options_(options), random_(options.seed) {}

  /// The chosen plane, an index into the set's planes (a dividing plane is added to them). `items`,
  /// one polygon each, must not be empty.
  std::uint32_t choose(const std::vector<std::uint32_t>& items);

 private:
  std::vector<std::uint32_t> sampled(const std::vector<std::uint32_t>& items, std::size_t count);
  std::vector<std::uint32_t> candidates(const std::vector<std::uint32_t>& items);
  SideCounts count(std::uint32_t plane, const std::vector<std::uint32_t>& items,
                   std::uint64_t most_splits) const;
  std::uint32_t plane_of(std::uint32_t item) const {
    return set_.polygons[set_.items[item].first_polygon].plane;
  }
  std::uint32_t fewest_splits(const std::vector<std::uint32_t>& items);
  std::uint32_t most_conflicts(const std::vector<std::uint32_t>& items);
  std::uint32_t least_cost(const std::vector<std::uint32_t>& items);

  WorkSet& set_;
  RootOptions options_;
  Random random_;
};

}  // namespace cigsim
