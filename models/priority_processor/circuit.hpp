// SPDX-License-Identifier: MIT
// Why a group's counts are not unique: a circuit of members each of which precedes the next, as in
// Stump 1986 (ch. III, Fig. 7), or a pair that no plane resolves. The machine only finds that there
// is a fault; naming it is ours.
#pragma once

#include <cstdint>

#include "models/boundary/transactions.hpp"
#include "models/database/database.hpp"

namespace cigsim::priority_processor {

/// Names the fault of a group at an eyepoint.
///
/// `objects`: the set of the hierarchy's items. `active`: a bit a member in view. `eye_true`: a bit
/// a node of the group, set when the eyepoint is on the TRUE side. The circuit is a shortest one;
/// among those the one that the lowest member begins, and it begins there. A member that is a group
/// is named by an object of its first item.
ListabilityFault listability_fault(const PriorityHierarchy& hierarchy, const FaceSet& objects,
                                   std::uint32_t group, std::uint64_t active,
                                   std::uint64_t eye_true);

}  // namespace cigsim::priority_processor
