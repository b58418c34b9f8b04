// SPDX-License-Identifier: MIT
// A separation as a scene that brings its table (docs/scene-format.md), so that any other part of
// the machine takes it.
#pragma once

#include "models/database/separation_planes/published.hpp"
#include "models/database/separation_planes/separate.hpp"

namespace cigsim::separation_planes {

/// `scene` with this table. The planes have unit normals, rounded, as he has them.
Environment with_table(Environment scene, const PublishedTable& table);

/// `scene` with this table, and with the parts of the objects that were split: the FALSE part in
/// the object's place, the TRUE part after all objects. Planes whose equation in whole numbers fits
/// into doubles are exact; others have unit normals, rounded.
Environment with_table(Environment scene, const SeparationResult& result);

/// Unit normal and directed distance of a plane, rounded.
UnitPlane unit_plane(const Plane& plane);

}  // namespace cigsim::separation_planes
