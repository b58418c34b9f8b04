// SPDX-License-Identifier: MIT
// The polygons of an environment, as a BSP tree takes them (Fuchs, Kedem, Naylor 1980).
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/work_set.hpp"
#include "models/environment/environment.hpp"
#include "models/environment/read.hpp"

namespace cigsim {

/// Planar convex polygons, each an item of the set and with a plane of its own: polygon k, item k
/// and plane k belong together, and FaceOrigin::order is k. The plane's normal is on the polygon's
/// front where the object is closed; else on the side from which its corners run anticlockwise.
struct BspPolygons {
  static constexpr std::uint32_t kNoBody = 0xffffffffu;

  WorkSet set;
  /// By polygon: the convex body of which it is a face, or kNoBody. No vertex of a body lies in
  /// front of one of its faces.
  std::vector<std::uint32_t> body;
  std::uint64_t faces = 0;  ///< of the objects, before non-planar and concave ones were cut
  std::uint64_t moving_objects = 0;  ///< left out: the tree holds what stands still
  std::vector<Notice> notices;
};

/// Every object that stands still, faces repaired as preparation repairs them (surface.hpp). Ground
/// faces are left out: they are below all polygons whichever way one looks.
BspPolygons bsp_polygons(const Environment& environment);

}  // namespace cigsim
