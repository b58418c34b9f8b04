// SPDX-License-Identifier: MIT
// An edge from line to line: the first element at or right of it on each.
#pragma once

#include <cmath>
#include <cstdint>

#include "models/boundary/certified_edges.hpp"

namespace cigsim::edge_orderer {

/// Writes to element[0 .. end - begin) the smallest whole number not below the edge's crossing on
/// each of the lines [begin, end), which the edge must cover, clamped to 0..width.
void step_edge(const Edge<float>& edge, int begin, int end, int width, std::int32_t* element);
void step_edge(const Edge<double>& edge, int begin, int end, int width, std::int32_t* element);

/// The same without rounding: x and slope over one denominator, and a whole remainder carried from
/// line to line.
void step_edge(const Edge<Exact>& edge, int begin, int end, int width, std::int32_t* element);

/// An edge's elements as doubles tell them.
///
/// Half an element to the right of the crossing, elements begin at halves: the nearest whole number
/// is the element, and the distance to it tells how far the crossing is from a sample, a half at
/// most. Beyond the raster's border there is no other element to confuse it with.
class CertainStep {
 public:
  CertainStep(const Edge<Certified>& edge, int width)
      : limit_(width),
        x_(edge.x + 0.5),
        slope_(edge.slope),
        room_(0.5 - edge.bound),
        first_line_(edge.first_line) {}

  /// The element on a line, and true; or false, and it may be wrong by one: a sample lies within
  /// the edge's error bound of the crossing.
  [[gnu::always_inline]] bool take(int line, std::int32_t& element) const {
    const double at = x_ + slope_ * static_cast<double>(line - first_line_);
    const double clamped = at > 0 ? (at < limit_ ? at : limit_) : 0;
    element = static_cast<std::int32_t>(clamped + 0.5);
    return !(!(std::abs(clamped - static_cast<double>(element)) < room_) | (at != at));
  }

 private:
  double limit_, x_, slope_, room_;
  int first_line_;
};

/// As step_edge() for doubles, and true; or false, and some lines are in doubt.
bool step_certain(const Edge<Certified>& edge, int begin, int end, int width,
                  std::int32_t* element);

}  // namespace cigsim::edge_orderer
