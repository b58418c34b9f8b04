// SPDX-License-Identifier: MIT
// What an object covers, exactly and in every case: eyes in line with edges, vertices on edges,
// objects that reach behind the eye, and pairs that no plane parts.
//
// Behind a convex object lies its shadow as seen from the eye: the points that the eye sees inside
// its outline, and, where the depth has to be asked, behind the planes of its front faces. A shadow
// is open: what lies on the outline is not covered. Only along seams between two figures of one
// body, or two cells of a concave figure, it is closed, so that nothing shows through them. An edge
// meets a convex shadow in one interval. This is a reconstruction beside the source's list of
// intersections, which stays the usual way.
#pragma once

#include <vector>

#include "models/hidden_line/crossing.hpp"

namespace cigsim::hidden_line {

struct OutlinePlane {
  SightPlane plane;
  bool closed = false;  ///< a seam: points on it are covered
};

/// One convex shadow.
struct Shadow {
  std::vector<OutlinePlane> outline;
  /// Planes of front faces with the sign of the eye's side. Asked for depth only.
  struct Front {
    const Plane* plane = nullptr;
    int eye_side = 1;
  };
  std::vector<Front> fronts;

  void clear() {
    outline.clear();
    fronts.clear();
  }
};

/// A piece of an edge, with its ends or without.
struct Interval {
  Crossing low = Crossing::start(), high = Crossing::end();
  bool has_low = true, has_high = true;
};

bool covers(const Shadow& shadow, bool by_depth, const SeenPoint& point, const Eye& eye);

/// The piece of a b in the shadow; false when there is none.
bool covered_piece(const Shadow& shadow, bool by_depth, const SeenPoint& a, const SeenPoint& b,
                   const Eye& eye, Interval& out);

/// Joins pieces that overlap or touch in a point that one of them has, in order along the edge.
void join(std::vector<Interval>& pieces, const Eye& eye);

}  // namespace cigsim::hidden_line
