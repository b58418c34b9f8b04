// SPDX-License-Identifier: MIT
// Solids and surfaces for tests, with faces that are exactly planar and anticlockwise from outside.
#pragma once

#include <vector>

#include "models/environment/environment.hpp"
#include "models/environment/random.hpp"

namespace cigsim::test {

/// A uniformly random direction of about unit length.
Vec3 random_direction(Random& random);

/// A random rotation, rounded.
Mat3 random_turn(Random& random);

/// The box between two corners.
Object box_between(const Vec3& low, const Vec3& high);

/// The convex hull of the points, with one face a plane; decided exactly by trying every three
/// points. Points that are no corners of a face stay in the vertex list unused.
Object exact_hull(const std::vector<Vec3>& points);

/// A polygon by itself.
Object polygon(const std::vector<Vec3>& corners);

/// Bodies within the sphere of radius r around c. All but the hulls of random points are turned, so
/// that rounding takes their corners out of line by an ulp or so: faces are those of the exact
/// hull.
Object random_box(const Vec3& c, double r, Random& random);
Object random_prism(const Vec3& c, double r, Random& random);
Object random_tetrahedron(const Vec3& c, double r, Random& random);
Object random_hull(const Vec3& c, double r, Random& random);
Object random_body(const Vec3& c, double r, Random& random);

}  // namespace cigsim::test
