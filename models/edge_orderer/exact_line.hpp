// SPDX-License-Identifier: MIT
// An edge of a certified frame as a line of the raster without rounding: columns are quotients of
// whole numbers.
#pragma once

#include <cstdint>

#include "models/boundary/certified_edges.hpp"
#include "models/boundary/exact_direction.hpp"

namespace cigsim::edge_orderer {

class ExactLine {
 public:
  ExactLine() = default;
  /// `axes`: of the list's view.
  ExactLine(const EdgeList<Certified>& list, const ExactAxes& axes, const Edge<Certified>& edge);

  /// The first element at or right of the edge on a line that it covers, clamped to 0..width.
  std::int32_t element(int line, int width) const;
  /// The same element on every line.
  bool upright() const { return sgn(step_) == 0; }

 private:
  void through_vertices(const EdgeList<Certified>& list, const ExactAxes& axes,
                        const Edge<Certified>& edge);

  // On line r the edge crosses column (start_ + step_ (r - first_line_)) / unit_.
  mpz_class start_, step_, unit_;
  int first_line_ = 0;
};

}  // namespace cigsim::edge_orderer
