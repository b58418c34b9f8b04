// SPDX-License-Identifier: MIT
// From a finished polyhedron to a hull: coplanar triangles are merged, and corners that are no
// extreme points dropped.
#pragma once

#include <span>
#include <vector>

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

/// The hull of any points. Search(points, start, extreme points) looks for it where they span
/// space: run() finds polyhedron(), with counters().
template <class Search>
Hull find_hull(std::span<const Vec3> given) {
  const ExactPoints points(given);
  const std::vector<std::uint32_t> extreme = extreme_points(points);
  const HullStart start = find_start(points, extreme);
  if (start.dimension < 3) return flat_hull(points, start);
  Search search(points, start, extreme);
  search.run();
  return finish_hull(search.polyhedron(), search.counters());
}

}  // namespace cigsim
