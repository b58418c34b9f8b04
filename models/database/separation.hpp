// SPDX-License-Identifier: MIT
// A plane between two items, where there is one.
#pragma once

#include <optional>

#include "models/database/work_set.hpp"

namespace cigsim {

/// A plane with `a` on its closed positive side and `b` on its closed negative side, not both in
/// it; verified exactly. Tried in this order: planes of faces, planes that contain an edge of one
/// item and are parallel to an edge of the other, any plane between the two hulls. Nothing when
/// none of these separates (hulls that interpenetrate, or too many edges to try).
std::optional<Plane> separating_plane(const WorkSet& set, const WorkItem& a, const WorkItem& b);

}  // namespace cigsim
