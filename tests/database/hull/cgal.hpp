// SPDX-License-Identifier: MIT
// CGAL's hull and smallest sphere, behind plain vectors: its headers take long to compile.
#pragma once

#include <span>
#include <vector>

#include "models/numeric/vec3.hpp"

namespace cigsim::test {

/// CGAL's extreme_points_3, the corners of its convex_hull_3, decided exactly; sorted.
std::vector<Vec3> cgal_hull_corners(std::span<const Vec3> points);

/// The radius of CGAL's Min_sphere_of_spheres_d in doubles.
double cgal_radius(std::span<const Vec3> points);

}  // namespace cigsim::test
