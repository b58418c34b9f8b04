// SPDX-License-Identifier: MIT
// Edges of certified frames: doubles with a bound on their error, and what is needed to work out
// without rounding what such a bound leaves in doubt. cigsim's own; filters of this manner are
// described by Shewchuk (1997).
#pragma once

#include <array>

#include "models/boundary/transactions.hpp"

namespace cigsim {

/// A number type: doubles with error bounds, so that each decision is certain or redone exactly.
/// What stages of this type decide is what they decide in Exact.
struct Certified {};

/// As Edge<double>, and how far the column may be off.
template <>
struct Edge<Certified> {
  int first_line = 0, end_line = 0;
  bool left = false;
  SetId set = SetId::kStatic;  ///< of the vertices
  double x = 0, slope = 0;     ///< as in Edge<double>
  /// On every line of the edge, x + slope (r - first_line), computed in doubles, is off by less
  /// than this, in elements; 1/2 or more says nothing.
  double bound = 0;
  /// The edge lies on the line through these two vertices of the set; with `from` = kNone it is
  /// EdgeList::exact[to].
  std::uint32_t from = 0, to = 0;
};

/// How much the geometry processor of a certified frame decided, and how much of it exactly.
struct GeometryRedone {
  std::uint64_t vertices = 0;  ///< their place against the pyramid of vision and the lines
  std::uint64_t vertices_redone = 0;
  std::uint64_t faces = 0;         ///< turned to the eyepoint and not outside one side
  std::uint64_t faces_redone = 0;  ///< clipped and projected in rational numbers
};

/// As EdgeList, with what exact edges are made from: the view, and the face sets of the frame by
/// SetId, which must outlive the list.
template <>
struct EdgeList<Certified> {
  std::vector<RasterFace> faces;
  std::vector<Edge<Certified>> edges;
  std::vector<Edge<Exact>> exact;  ///< edges of faces that were worked out exactly
  ViewTransform view;
  std::array<const FaceSet*, 3> sets{};
  GeometryRedone redone;
};

}  // namespace cigsim
