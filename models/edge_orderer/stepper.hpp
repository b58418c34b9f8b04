// SPDX-License-Identifier: MIT
// An edge from line to line: the first element at or right of it on each.
#pragma once

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

/// As for doubles, and true; or false, and some lines are in doubt: a sample lies within the edge's
/// error bound of it. On those the element may be wrong by one.
bool step_certain(const Edge<Certified>& edge, int begin, int end, int width,
                  std::int32_t* element);

}  // namespace cigsim::edge_orderer
