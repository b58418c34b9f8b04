// SPDX-License-Identifier: MIT
// From an exact sphere to the doubles that are given out.
#pragma once

#include "models/database/sphere/sphere.hpp"
#include "models/database/sphere/sphere_through.hpp"

namespace cigsim {

/// Centre to nearest, radius upward so that all that the exact sphere holds is held. Throws
/// std::invalid_argument when that radius is beyond the largest double.
BoundingSphere rounded(const SphereThrough& sphere);

}  // namespace cigsim
