// SPDX-License-Identifier: MIT
// From the surface of an object to polygons of the working set.
#pragma once

#include <cstdint>

#include "models/database/surface.hpp"
#include "models/database/work_set.hpp"

namespace cigsim {

/// Adds the faces of a surface to the working set. `origin_of(face)` tells where a face comes from,
/// and `added()` is called after each.
template <class OriginOf, class Added>
void add_faces(WorkSet& set, const Surface& surface, OriginOf origin_of, Added added) {
  const auto base = static_cast<std::uint32_t>(set.vertex_count());
  for (const Vec3& v : surface.vertices) set.add_vertex(v);
  Loop corners;
  for (const SurfaceFace& face : surface.faces) {
    corners = face.loop;
    for (std::uint32_t& c : corners) c += base;
    set.add_polygon(corners, set.add_plane(face.plane), origin_of(face));
    added();
  }
}

}  // namespace cigsim
