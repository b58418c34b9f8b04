// SPDX-License-Identifier: MIT
// Which faces a machine of words takes for ones to be shown (docs/machine/geometry_processor.md,
// GP4), whether or not anything of them comes out.
#pragma once

#include <vector>

#include "models/boundary/words.hpp"
#include "models/geometry_processor/memory.hpp"
#include "models/machine/description.hpp"

namespace cigsim::stability {

/// By the faces of the item; shorter, or empty, where it is not asked about them: the item lies
/// wholly outside a plane of the pyramid. `item` is no end word.
std::vector<bool> shown_faces(const MachineDescription& machine,
                              const geometry_processor::GeometryBank& bank, const ItemWord& item);

}  // namespace cigsim::stability
