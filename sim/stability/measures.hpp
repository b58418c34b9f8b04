// SPDX-License-Identifier: MIT
// What decides whether a number format is enough for a frame: sizes, distances and clearances of a
// scene as one viewpoint has them. The envelope's limits are limits of these.
#pragma once

#include "models/boundary/transactions.hpp"
#include "models/database/database.hpp"

namespace cigsim::stability {

struct Measures {
  double smallest = 0;   ///< radius of the smallest item, environment units
  double largest = 0;    ///< largest coordinate of the items' spheres and the eyepoint, units
  double demand = 0;     ///< elements that `largest` would span at the distance of what is nearest
  double lines = 0;      ///< the larger side of the raster, elements
  double cut = 0;        ///< the same of the nearest face that reaches out of the pyramid of vision
  double nearness = 0;   ///< distance of the nearest point of a face, as a share of `largest`
  double clearance = 0;  ///< distance of the eyepoint from the nearest plane, as a share of it

  /// The worse of both, field by field.
  Measures& operator|=(const Measures& other);
};

/// Of a frame: of what retrieval finds in view, as the frame calculator's result has it. Planes are
/// the separation planes that have active members on both sides, and those of all faces of `items`.
/// Planes across an axis in which the eyepoint lies at a coordinate that every format holds do not
/// count: there nothing is rounded. With nothing in view only `lines` and `largest` are told; the
/// rest is what asks least.
Measures measures_of(const Database& database, const ActiveEnvironment& active,
                     const FaceSet& moving, const std::vector<ItemRef>& items);

}  // namespace cigsim::stability
