// SPDX-License-Identifier: MIT
// Polygons and planes in rational arithmetic, without the filters of the models: oracles for trees.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "models/database/bsp/polygons.hpp"

namespace cigsim::test {

using ExactLoop = std::vector<ExactVec>;

/// The corners of an item's polygon.
ExactLoop exact_loop(const WorkSet& set, std::uint32_t item);

/// Sum over the triangles of a fan of (b - a) x (c - a): twice the area, as a vector.
ExactVec area_vector(const ExactLoop& loop);

/// +1 and -1 where all corners lie on the closed side, 0 where all lie in the plane, 2 across it.
int side_of_loop(const Plane& plane, const ExactLoop& loop);

/// Where the ray eye + t d, t > 0, meets the closed convex polygon, t; nothing where it does not or
/// runs in its plane.
std::optional<Exact> hit(const ExactLoop& loop, const ExactVec& eye, const ExactVec& d);

/// Polygons, each a polygon of its own without a body, in this order.
BspPolygons polygons_of(const std::vector<std::vector<Vec3>>& loops);

}  // namespace cigsim::test
