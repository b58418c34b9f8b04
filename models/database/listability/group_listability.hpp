// SPDX-License-Identifier: MIT
// What a prepared database claims of its priorities, as tables to be proved, and whether each item
// lies where its pairs say.
//
// The list of a hierarchy opens group after group, so it is a right order from every eyepoint when
// every group's counts are unique and every pair's items lie on their sides of its plane.
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/database.hpp"
#include "models/database/listability/listability.hpp"

namespace cigsim::listability {

/// The table of a group: member m is the group's member m, plane n its node n. A node that lists no
/// pairs stands for every TRUE with every FALSE member.
PriorityTable table_of_group(const PriorityHierarchy& hierarchy, std::uint32_t group);

/// An item that does not lie on the side of a plane that the plane's pairs say.
struct SideFault {
  std::uint32_t group = 0, node = 0, item = 0;
  bool true_side = false;  ///< the side that the pairs say
  double depth = 0;        ///< how far it reaches to the other side
};

struct SideCheck {
  std::uint64_t tests = 0;      ///< of an item at a plane
  std::uint64_t tolerated = 0;  ///< reach across within the contact tolerance
  double deepest = 0;           ///< of those, length
  std::uint64_t fault_count = 0;
  std::vector<SideFault> faults;  ///< the first
};

/// Tests every vertex exactly; an item may touch its planes or lie in them. `contact_tolerance` as
/// in PrepareOptions. `most`: faults that are kept.
SideCheck check_sides(const PriorityHierarchy& hierarchy, const FaceSet& set,
                      double contact_tolerance, std::size_t most = 8);

}  // namespace cigsim::listability
