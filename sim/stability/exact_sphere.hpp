// SPDX-License-Identifier: MIT
// The referee of smallest spheres: a certificate in rational arithmetic.
//
// A sphere through some points, whose centre is a mean of them with weights that are not negative,
// is the smallest round these; if it holds all other points too, it is the smallest round all. The
// centre comes from the linear equations of equal distance, not from products as in
// models/database/sphere.
#pragma once

#include <span>

#include "models/database/sphere/sphere.hpp"

namespace cigsim::stability {

struct SphereProof {
  /// The support makes the smallest sphere, and the rounded sphere holds every point.
  bool right = false;
  /// Radius given less the exact one, and the most that rounding centre and radius once explains:
  /// half an ulp of the centre in each coordinate, an ulp of the radius. Environment units.
  double excess = 0, bound = 0;
};

SphereProof prove(const BoundingSphere& sphere, std::span<const Vec3> points);

}  // namespace cigsim::stability
