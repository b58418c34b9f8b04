// SPDX-License-Identifier: MIT
// Flat shades that the data base fixes: the default palette and the sun.
#pragma once

#include "models/environment/environment.hpp"

namespace cigsim {

/// The colour of an object that states none, so that neighbours in number differ.
Colour palette_colour(std::uint32_t object_number);

/// Unit vector towards the sun.
Vec3 towards(const Sun& sun);

/// Sandor 1979 (sec. 6.1): 60 % of the shade follows the cosine of the sun's angle to the face's
/// normal (of any length), 40 % is diffuse.
Colour shaded(Colour colour, const Vec3& normal, const Vec3& towards_sun);

}  // namespace cigsim
