// SPDX-License-Identifier: MIT
// Composites that a separation plane cannot be taken with.
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/detail/composite.hpp"

namespace cigsim {

/// Of `items`, composites that the plane would have to cut and must not, and those that share the
/// plane with another item's polygons where it would show the wrong one of the two. Where faces of
/// one plane overlap, the first in the input is to be seen (a sheet, whose faces have a fixed
/// order); a composite can be in no sheet, so that the one which the plane brings to the front must
/// come first by itself. `face_plane` as in WorkSet::classify.
std::vector<std::uint32_t> hindered_by(const WorkSet& set, const Composites& composites,
                                       const Plane& plane, std::uint32_t face_plane,
                                       const std::vector<std::uint32_t>& items);

}  // namespace cigsim
