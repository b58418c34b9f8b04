// SPDX-License-Identifier: MIT
// An object's faces made fit for the machine: planar, convex, facing outwards.
//
// Rules, in this order (docs/how-it-works.md tells them to users):
//  - vertices at equal coordinates are one vertex;
//  - repeated corners go; a face without area goes; of equal faces with equal winding the first
//  stays;
//  - a vertex of an open edge that lies on another open edge is put into it, if that closes the
//    object (T-junctions);
//  - where every edge is shared by exactly two faces, the windings are made to agree, and each part
//    faces outwards, except a part within another that the input winds inwards (a cavity);
//  - an object is closed when every edge is passed equally often in both directions. An unclosed
//    object is seen from both sides;
//  - a face that is not planar becomes triangles: those of the convex hull where the object is
//    closed, else ears; a face that is not convex becomes convex ones;
//  - an object is convex when it is closed, in one part, and no vertex lies in front of a face; its
//    coplanar faces of one colour that share edges are joined.
#pragma once

#include "models/database/notices.hpp"
#include "models/database/polygon.hpp"
#include "models/environment/environment.hpp"

namespace cigsim {

struct SurfaceFace {
  Loop loop;                 ///< convex; vertices of the surface
  Plane plane;               ///< exact; normal on the side from which the loop runs anticlockwise
  std::uint32_t source = 0;  ///< index of the input face
};

struct Surface {
  std::vector<Vec3> vertices;
  std::vector<SurfaceFace> faces;
  bool closed = false, convex = false;
};

Surface make_surface(const Object& object, Notices& notices);

}  // namespace cigsim
