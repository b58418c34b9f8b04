// SPDX-License-Identifier: MIT
// The line of an edge without rounding in whole numbers of 128 bits, where they hold it. They do
// where it matters: views along an axis, which lay edges through rows and columns of samples, have
// a view matrix of a few bits, and most edges are parallel to one of its axes.
#pragma once

#include <cstdint>
#include <optional>

#include "models/boundary/transactions.hpp"

namespace cigsim::edge_orderer {

/// On line r the edge crosses column (start + step (r - first_line)) / unit; unit > 0.
struct ShortLine {
  using Whole = __int128;
  Whole start = 0, step = 0, unit = 1;
  int first_line = 0;

  /// As of ExactLine.
  std::int32_t element(int line, int width) const;
  bool upright() const { return step == 0; }
};

/// A view as whole numbers times powers of two.
class ShortView {
 public:
  ShortView() = default;
  explicit ShortView(const ViewTransform& view);

  /// The line through two vertices on the raster, where it must not be level. Nothing: the numbers
  /// are too long. `first_line`: of the edge, in 0..2^14.
  std::optional<ShortLine> line(const Vec3& a, const Vec3& b, int first_line) const;

 private:
  using Whole = ShortLine::Whole;

  bool holds_ = false;  // the rotation; if not, nothing has a short line
  Mat3T<Whole> rotation_;
  int rotation_bits_ = 0;
  Vec3 eye_;
  int eye_exponent_ = 0;
  // The focal length is focal_ times 2^focal_exponent_.
  Whole focal_ = 0;
  int focal_exponent_ = 0, focal_bits_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace cigsim::edge_orderer
