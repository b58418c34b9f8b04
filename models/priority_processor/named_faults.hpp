// SPDX-License-Identifier: MIT
// The listability faults that the machine reports, named (circuit.hpp).
#pragma once

#include <vector>

#include "models/priority_processor/circuit.hpp"
#include "models/priority_processor/memory.hpp"

namespace cigsim::priority_processor {

/// `faults`: Figures::faults of the frame that `active` and `view` are of. `objects`: the set of
/// the hierarchy's items. `scale`, `formats`: those of the memory. The eyepoint is on the side of
/// each plane that the machine's words say.
std::vector<ListabilityFault> named_faults(const PriorityHierarchy& hierarchy,
                                           const FaceSet& objects, const ActiveEnvironment& active,
                                           const ViewWords& view, int scale,
                                           const WordFormats& formats,
                                           const std::vector<std::uint32_t>& faults);

}  // namespace cigsim::priority_processor
