// SPDX-License-Identifier: MIT
// Clipping of a face's loop to the pyramid of vision in doubles with error bounds, plane by plane
// as in clip.hpp; where a bound leaves a cut of an edge in doubt, without rounding. The bounds are
// derived in functional_certified.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "models/boundary/exact_direction.hpp"
#include "models/geometry_processor/clip.hpp"

namespace cigsim::geometry_processor {

/// A point of the viewpoint system, each coordinate off by less than `error`.
struct CertifiedPoint {
  double u = 0, v = 0, w = 0, error = 0;
};

/// The line on which an edge of a loop lies: through two vertices of the item, or with a == kNone
/// the side b of the pyramid, as PyramidSides counts them.
struct LoopLine {
  std::uint32_t a = kNone, b = 0;
};

/// A corner of a loop, and the edge from it to the next.
struct LoopCorner {
  CertifiedPoint at;
  LoopLine edge;
  std::uint32_t vertex = kNone;  ///< of the item, if it is one
  std::uint8_t outside = 0;      ///< a bit a side
  std::uint8_t unknown = 0;      ///< sides of which `outside` is not known
  LoopLine cut;                  ///< if it is no vertex, the line that was cut
  int cut_side = 0;              ///< and the side of the pyramid that cut it
};

/// A view without rounding.
struct ExactPyramid {
  explicit ExactPyramid(const ViewTransform& view) : axes(view), sides(view) {}

  ExactAxes axes;
  PyramidSides<Dyadic> sides;
};

class CertifiedClip {
 public:
  CertifiedClip() = default;
  /// The view must outlive it.
  explicit CertifiedClip(const ViewTransform& view);

  /// A point's distance from a side is off by less than this times its error.
  double spread() const { return spread_; }
  /// Clips the loop against the sides of `sides`; its vertices are those of the set from
  /// `first_vertex` on. False: a decision remained in doubt, and the loop means nothing.
  bool clip(std::uint8_t sides, const FaceSet& set, std::uint32_t first_vertex,
            std::vector<LoopCorner>& loop);
  /// The last clip() decided something without rounding.
  bool settled() const { return settled_; }
  /// Made at the first call.
  const ExactPyramid& exact();

 private:
  double distance(int side, const CertifiedPoint& p) const;
  bool classify(int side, const FaceSet& set, std::uint32_t first_vertex, LoopCorner& corner);
  bool settle(int side, const FaceSet& set, std::uint32_t first_vertex, LoopCorner& corner);
  LoopCorner cut(const LoopCorner& a, const LoopCorner& b, int side) const;

  const ViewTransform* view_ = nullptr;
  std::optional<ExactPyramid> exact_;
  bool settled_ = false;
  double focal_ = 0, half_width_ = 0, half_height_ = 0, spread_ = 0;
  std::vector<LoopCorner> scratch_;
};

}  // namespace cigsim::geometry_processor
