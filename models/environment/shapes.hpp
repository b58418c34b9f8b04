// SPDX-License-Identifier: MIT
// Convex solids for generated scenes. Faces are anticlockwise as seen from outside. Where the given
// coordinates are multiples of one power of two (and not too large), faces are exactly planar.
#pragma once

#include <span>
#include <vector>

#include "models/environment/environment.hpp"

namespace cigsim {

/// The box between two corners.
Object box(const Vec3& low, const Vec3& high);

/// The eight points centre ± a ± b ± c, where a, b, c are right-handed.
Object parallelepiped(const Vec3& centre, const Vec3& a, const Vec3& b, const Vec3& c);

/// `base`, anticlockwise as seen from the tip of `up`, swept along `up`.
Object prism(const std::vector<Vec3>& base, const Vec3& up);

/// The convex hull with triangles, by trying every three points: for a handful of points. Without
/// faces when four points lie on one plane or a point is not a corner of the hull.
Object hull(std::span<const Vec3> points);

}  // namespace cigsim
