// SPDX-License-Identifier: MIT
// The geometry processor's microprogram for a machine's word formats.
#pragma once

#include "firmware/assembler/program.hpp"
#include "models/boundary/words.hpp"
#include "models/machine/description.hpp"

namespace cigsim::geometry_processor {

/// Clocks of a quotient and of a slope, two bits each (GP7, GP13).
int quotient_clocks(const WordFormats& formats);
int slope_clocks(const WordFormats& formats);

/// Assembled so that the divider is waited for as long as the machine's words need.
firmware::Program program(const WordFormats& formats);

/// Cycles from a start word on after which no face and no item is begun; none under kExtend and
/// without a frame time (GP16).
Cycle deadline(const MachineDescription& machine, OverloadPolicy overload);

}  // namespace cigsim::geometry_processor
