// SPDX-License-Identifier: MIT
// A few triangles through the machine's own geometry processor and edge orderer, in any format.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "models/edge_orderer/functional.hpp"
#include "sim/stability/decision.hpp"

namespace cigsim::stability {

struct Drawing {
  struct Face {
    std::uint32_t triangle = 0;  ///< its place among those given
    int first_line = 0, end_line = 0;
  };
  /// An edge as the orderer gets it, its doubles or words taken as exact. Certified: none.
  struct Line {
    std::uint32_t triangle = 0;
    int first_line = 0, end_line = 0;
    bool left = false;
    Exact x, slope;
  };
  std::vector<Face> faces;  ///< those drawn, in order
  std::vector<Line> edges;
  /// Crossing::face is the place in `faces`.
  edge_orderer::OrderedCrossings crossings;
  /// By triangle: the format takes it for one to be shown, whether or not anything comes out. Empty
  /// where words are not asked: nothing of the item is in view.
  std::vector<bool> shown;
  bool doubtful = false;  ///< words saturated, or an edge's place is not finite

  /// Elements [first, end) of a line that a triangle covers; first == end: none.
  struct Cover {
    int first = 0, end = 0;
  };
  Cover cover(std::uint32_t triangle, int line) const;
};

/// One item whose faces are the triangles, in this order; front faces only, or both sides.
Drawing draw(std::span<const Triangle> triangles, bool two_sided, const ViewTransform& view,
             const Format& format);

/// The database that it draws: for those who need its words too, or change it.
Database database_of(std::span<const Triangle> triangles, bool two_sided);
/// A database of that kind.
Drawing draw(const Database& database, const ViewTransform& view, const Format& format);

}  // namespace cigsim::stability
