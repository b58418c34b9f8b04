// SPDX-License-Identifier: MIT
// Which groups and items are in view: spheres against the pyramid of vision, from the root down,
// and of each choice that is met one description.
#pragma once

#include <unordered_map>

#include "models/boundary/transactions.hpp"
#include "models/frame_calculator/detail.hpp"

namespace cigsim::frame_calculator {

/// Members that are active in any case, a mask a group.
using ForcedMembers = std::unordered_map<std::uint32_t, std::uint64_t>;

/// Conservative: a member is left out only if its sphere is outside beyond all rounding, or if it
/// is a description that is not shown. `choices` are the hierarchy's. Without `spheres` none is
/// tested: everything that is shown is active.
void retrieve(const PriorityHierarchy& hierarchy, const ViewTransform& view,
              const ForcedMembers& forced, bool spheres, Choices& choices,
              std::vector<ActiveGroup>& out);

}  // namespace cigsim::frame_calculator
