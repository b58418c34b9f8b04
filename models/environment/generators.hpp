// SPDX-License-Identifier: MIT
// The generators behind generate_environment. Each fills in the objects (and the ground); names,
// models and the view come from the caller.
#pragma once

#include "models/environment/environment.hpp"
#include "models/environment/random.hpp"

namespace cigsim {

void generate_city(Environment& environment, std::uint32_t objects, Random& random);
void generate_cubes(Environment& environment, std::uint32_t objects, Random& random);
void generate_random(Environment& environment, std::uint32_t objects, Random& random);
void generate_brushes(Environment& environment, std::uint32_t objects, Random& random);
void generate_soup(Environment& environment, std::uint32_t objects, Random& random);

/// The nearest multiple of 1/1024.
double on_grid(double value);
Vec3 on_grid(const Vec3& value);

/// A random rotation (a uniform quaternion), rows orthonormal but for rounding.
Mat3 random_rotation(Random& random);

/// The least m with m^power >= n.
std::uint32_t root_up(std::uint32_t n, int power);

}  // namespace cigsim
