// SPDX-License-Identifier: MIT
// The referee of pictures: what a triangle covers, in rational arithmetic, by rays instead of
// projected edges.
//
// The rays from the eyepoint through a triangle make a cone with three flat sides. A sample shows
// the triangle when its ray lies in the cone. No vertex is projected, clipped or divided by its
// distance, so that nothing is shared with the machine's way.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/numeric/plane.hpp"
#include "sim/stability/material.hpp"

namespace cigsim::stability {

/// The side of a plane that a point is on, from the polynomial as it stands: −1, 0, 1.
int exact_side(const PlaneDefinition& plane, const Vec3& point);
/// The point's distance from the plane, environment units; 0 without a normal.
double distance_from(const PlaneDefinition& plane, const Vec3& point);

/// Of a point in the viewpoint system, for the view's doubles: u ahead, v right, w up.
ExactVec in_view(const ViewTransform& view, const Vec3& point);
/// Its row on the raster: height/2 − focal w/u; u must not be 0.
Exact exact_row(const ViewTransform& view, const ExactVec& in_view);

/// What a triangle covers of a line: columns measured to the right from the first element's sample,
/// between the borders of the raster. Elements e with low <= e < high are covered.
struct Reach {
  Exact low, high;
  int first = 0, end = 0;  ///< of those elements
};

class Sight {
 public:
  /// `eye_side`: as `facing`. Nothing is covered when the eyepoint is in the triangle's plane.
  Sight(const Triangle& triangle, const ViewTransform& view);

  /// +1 when the eyepoint sees the corners run anticlockwise, −1 clockwise, 0 in the plane.
  int facing() const { return facing_; }
  /// All corners lie strictly within the pyramid of vision.
  bool whole() const { return whole_; }
  /// Of a whole triangle: the first line whose sample is not above it, and the first not above its
  /// lower end. From the corners' rows.
  int first_line() const { return first_line_; }
  int end_line() const { return end_line_; }
  /// Rows of the corners; of a whole triangle only.
  const std::array<Exact, 3>& rows() const { return rows_; }

  /// None: no sample point of the line, between elements included, is covered.
  std::optional<Reach> reach(int line) const;
  /// How far a point of the raster is from the nearest border of the triangle (or of the raster),
  /// on its left or right side, in elements; `column` as in Reach, on the sample height of `line`.
  double distance_from_border(int line, const Exact& column, bool left) const;
  /// The same of an element's sample, from the borders on all sides, each as long as its line.
  double distance_from_all(int line, int element) const;

 private:
  // A side of the cone as it meets a line: a + b · column >= 0 is inside, column measured from the
  // raster's left border.
  struct Side {
    Exact a, b;
  };
  Side at_line(const ExactVec& normal, int line) const;
  /// Of border i, which must have a direction on the raster; `at` measured as b counts.
  double distance(std::size_t i, const Side& side, const Exact& at) const;

  ViewTransform view_;
  std::array<ExactVec, 3> normals_;
  std::array<Exact, 3> largest_;   // of a normal's elements across the line of sight
  std::array<double, 3> slant_{};  // their length over that
  std::array<Exact, 3> rows_;
  int facing_ = 0, first_line_ = 0, end_line_ = 0;
  bool whole_ = false;
};

}  // namespace cigsim::stability
