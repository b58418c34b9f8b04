// SPDX-License-Identifier: MIT
// Choices in the working set of preparation. A choice's descriptions fill the same space and one of
// them is shown at a time, so they need no planes between each other; but whatever else there is
// must be parted from all of them. A *composite* is an item that holds the polygons of all
// descriptions at once: the partition classifies it like any other, and where a plane must cut it,
// every description is cut along. How descriptions stay out of each other's way is a
// reconstruction; Levine 1975, whose choices these are (ch. II.G), has no planes there.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "models/database/work_set.hpp"

namespace cigsim {

struct Composite {
  std::uint32_t choice = 0;
  /// Items of each description, the least detailed first; they may be composites themselves.
  std::vector<std::vector<std::uint32_t>> descriptions;
};

/// The polygons of an item that lie in a plane and are seen from one side of it.
struct InPlane {
  bool any = false;
  std::uint32_t first_order = 0, last_order = 0;  ///< FaceOrigin::order: the first wins
};

/// Of any item: seen from the normal's side, and from the other.
std::array<InPlane, 2> in_plane(const WorkSet& set, const Plane& plane, const WorkItem& item);

class Composites {
 public:
  /// False: cut() is not to be called.
  bool may_cut = true;

  bool empty() const { return by_item_.empty(); }
  /// The composite that an item is, or nullptr.
  const Composite* find(std::uint32_t item) const {
    if (by_item_.empty()) return nullptr;
    const auto at = by_item_.find(item);
    return at == by_item_.end() ? nullptr : &at->second;
  }

  /// Adds an item for a composite of which at least one description has an item; returns it.
  std::uint32_t add(WorkSet& set, Composite composite);

  struct Cut {
    std::array<std::uint32_t, 2> items{};  ///< {positive, negative}; kNothing: there is no part
    std::uint64_t cuts = 0, tolerated = 0;
  };
  /// Cuts all descriptions along a plane. A polygon in the plane goes to the side from which it is
  /// not seen, where bodies with a face in the plane that is seen from the same side are.
  Cut cut(WorkSet& set, const Plane& plane, std::uint32_t item);
  /// Whether a part lies in the plane that cut() could not give to one side.
  bool holds_two_sided_in(const WorkSet& set, const Plane& plane, std::uint32_t item) const;
  /// Whether a composite of this choice has been cut.
  bool was_cut(std::uint32_t choice) const;

 private:
  std::unordered_map<std::uint32_t, Composite> by_item_;
  std::vector<bool> was_cut_;  // by choice
};

}  // namespace cigsim
