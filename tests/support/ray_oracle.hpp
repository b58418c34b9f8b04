// SPDX-License-Identifier: MIT
// Brute-force ray casting in rational arithmetic: the object that each element of a picture must
// show. It shares no code with the machine beyond the view matrix, whose doubles it takes as exact.
#pragma once

#include <cstdint>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/environment/environment.hpp"

namespace cigsim::test {

/// A planar convex polygon, anticlockwise from its front.
struct OraclePolygon {
  std::vector<Vec3> vertices;
  std::uint32_t object = 0;
  bool two_sided = false;
};

/// All faces of an environment's objects as they stand (system 0 only).
std::vector<OraclePolygon> oracle_polygons(const Environment& environment, bool two_sided);

/// Object numbers, row by row from the top; 0 where no polygon is hit. A sample on an edge counts
/// as a little to the right of it, or below a level one. Of coplanar polygons the first in the list
/// is seen.
std::vector<std::uint16_t> cast_rays(const std::vector<OraclePolygon>& polygons,
                                     const ViewTransform& view);

/// Distance in elements from the centre of element (c, r) to the nearest projected edge of any
/// polygon (double; edges clipped to what lies ahead of the eyepoint).
double distance_to_edge(const std::vector<OraclePolygon>& polygons, const ViewTransform& view,
                        int column, int row);

}  // namespace cigsim::test
