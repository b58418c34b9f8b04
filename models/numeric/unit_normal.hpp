// SPDX-License-Identifier: MIT
// The direction of a plane's normal, for formats that keep no more than that.
#pragma once

#include "models/numeric/plane.hpp"

namespace cigsim {

/// Of length 1; each element is within 2^-38 of the exact normal's direction. (0, 0, 0) where the
/// plane has no normal. The rounded normal will do for nearly all planes; where the points that
/// define one lie almost on a line, rounding may have turned it by any angle, and the exact normal
/// is taken.
Vec3 unit_normal(const Plane& plane);

}  // namespace cigsim
