// SPDX-License-Identifier: MIT
// Lengths and directions of doubles, as those who pose instances and those who measure them take
// them: rounded, and safe where squares would leave the doubles.
#pragma once

#include "models/environment/random.hpp"
#include "models/numeric/vec3.hpp"

namespace cigsim::stability {

double length(const Vec3& v);
double largest_coordinate(const Vec3& v);

/// A vector of about unit length in the same direction; a zero vector gives itself.
Vec3 direction_of(const Vec3& v);
/// The same, but a zero vector gives the x axis.
Vec3 unit(const Vec3& v);
/// Of about unit length.
Vec3 random_direction(Random& random);

}  // namespace cigsim::stability
