// SPDX-License-Identifier: MIT
// From a finished polyhedron to a hull: coplanar triangles are merged, and corners that are no
// extreme points dropped.
#pragma once

#include "models/database/hull/hull.hpp"
#include "models/database/hull/polyhedron.hpp"
#include "models/database/hull/start.hpp"

namespace cigsim {

/// Triangles with what lies across their edges: neighbour[i] shares the edge from corner i to the
/// next.
struct TriangleMesh {
  std::vector<HullTriangle> triangles;
  std::vector<std::array<std::uint32_t, 3>> neighbours;
};

/// The neighbours of a closed surface's triangles.
TriangleMesh mesh_of(std::vector<HullTriangle> triangles);

/// The loops of corners of a convex surface's facets, coplanar triangles merged; a corner in the
/// middle of a straight side is left out. Each begins with its smallest corner.
std::vector<std::vector<std::uint32_t>> facet_loops(const ExactPoints& points,
                                                    const TriangleMesh& mesh);

Hull finish_hull(const Polyhedron& polyhedron, const HullCounters& counters);

/// The hull of points that do not span space (start.dimension below 3).
Hull flat_hull(const ExactPoints& points, const HullStart& start);

}  // namespace cigsim
