// SPDX-License-Identifier: MIT
// Clipping of a face's loop to the pyramid of vision in doubles with error bounds, plane by plane
// as in clip.hpp. The bounds are derived in functional_certified.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "models/boundary/transactions.hpp"

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
};

class CertifiedClip {
 public:
  CertifiedClip() = default;
  explicit CertifiedClip(const ViewTransform& view);

  /// A point's distance from a side is off by less than this times its error.
  double spread() const { return spread_; }
  /// Clips the loop against the sides of `sides`. False: a decision was in doubt, and the loop
  /// means nothing.
  bool clip(std::uint8_t sides, std::vector<LoopCorner>& loop);

 private:
  double distance(int side, const CertifiedPoint& p) const;
  bool classify(int side, LoopCorner& corner) const;
  LoopCorner cut(const LoopCorner& a, const LoopCorner& b, int side) const;

  double focal_ = 0, half_width_ = 0, half_height_ = 0, spread_ = 0;
  std::vector<LoopCorner> scratch_;
};

}  // namespace cigsim::geometry_processor
