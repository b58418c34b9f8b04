// SPDX-License-Identifier: MIT
// The convex hull of points in space, twice: Levine's algorithm of 1975 with his counters, and a
// fast one.
//
// Both decide every side of a plane exactly, for any finite doubles: first in doubles with an error
// bound, then without rounding. Coplanar, collinear and repeated points therefore need no
// tolerance, and points that do not span space have a hull of a lower dimension.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "models/numeric/vec3.hpp"

namespace cigsim {

using HullTriangle = std::array<std::uint32_t, 3>;

/// Work done. `tests` are Levine's NT: signed distances of a point from a plane.
struct HullCounters {
  std::uint64_t tests = 0;
  std::uint64_t rounds = 0;  ///< Levine: passes over all points left (his step 5)
  std::uint64_t added =
      0;  ///< points that became corners of the polyhedron, the first four included
  std::uint64_t faces = 0;  ///< triangles of the polyhedron at the end: 2 · corners − 4
  std::uint64_t exact = 0;  ///< sides that doubles could not decide
  friend bool operator==(const HullCounters&, const HullCounters&) = default;
};

/// All indices are places in the points given. Of equal points only one is named.
struct Hull {
  /// −1: no point, 0: all points equal, 1: on a line, 2: in a plane, 3: a solid.
  int dimension = -1;
  /// The extreme points: those that are not in the hull of the others. A point inside a face or an
  /// edge is none. Of a polygon in its order round; else ascending.
  std::vector<std::uint32_t> vertices;
  /// Triangles of a solid, anticlockwise as seen from outside, with corners in `vertices` only:
  /// 2 · vertices − 4 of them. A facet of more corners is cut into a fan. None below dimension 3.
  std::vector<HullTriangle> triangles;
  HullCounters counters;
};

/// Fast: a quickhull. Expected time n log h for n points with h on the hull; memory linear.
/// Throws std::invalid_argument for more than 2^31 points or a coordinate that is not finite.
Hull convex_hull(std::span<const Vec3> points);

/// Levine 1975, ch. IV, in time n · h: up to 14 points that are extreme in seven directions, a
/// tetrahedron, then rounds in which every point left is tested against every face that is not
/// final and the farthest ones of the faces are added with convex caps. Same hull as convex_hull().
Hull levine_hull(std::span<const Vec3> points);

/// Tests that Chand and Kapur's algorithm would take (Levine 1975, ch. IV, NEQ): 3 · n · faces.
std::uint64_t equivalent_tests(std::size_t points, std::size_t faces);

/// The faces of a hull with coplanar triangles merged, each a loop of corners: of a solid
/// anticlockwise from outside, of a polygon the polygon itself; none below dimension 2.
std::vector<std::vector<std::uint32_t>> hull_facets(std::span<const Vec3> points, const Hull& hull);

}  // namespace cigsim
