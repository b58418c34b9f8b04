// SPDX-License-Identifier: MIT
// What becomes of an edge that is stepped from line to line over a whole raster: a slope is rounded
// once, and its error grows with every line (docs/machine/edge_orderer.md, EO1; the descriptions of
// the machines say how far it grows in theirs).
//
// Each trial is a triangle that one edge crosses from the first line to the last. The geometry
// processor of each format sets the edge up, its edge orderer steps it, and the same triangle in
// rational arithmetic is the referee. Corners lie on multiples of 1/16 element, where a raster of
// 2^n lines projects them without rounding in every format: what is measured is then the slope
// alone.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/stability/decision.hpp"

namespace cigsim::stability {

struct AccumulationOptions {
  std::uint64_t seed = 1;
  int trials = 40;
  /// Lines and elements of the raster: even, 16..8190 (13.18 words hold 8,191).
  int lines = 4096;
  std::vector<Format> formats;
};

/// Over all trials, on the first `lines` lines of the edge.
struct AccumulationPoint {
  int lines = 0;
  /// Elements. Floating-point places can be seen to 2^-16 of an element only; less counts as 0.
  double worst = 0;
  double bound = 0;                        ///< slope_bound() of the worst edge, at this line
  bool held = true;                        ///< no edge was off by more than its bound on any line
  std::uint64_t crossings = 0, wrong = 0;  ///< elements of EO2; those that differ from exact ones
};

struct Accumulation {
  Format format;
  int raster = 0;  ///< lines
  std::vector<AccumulationPoint> points;
};

/// What a format's rules allow: how far the place of an edge of this slope can be off, in elements,
/// `line` lines below its first one on a raster of `lines` lines. On machine words with q bits of
/// a quotient and f of a raster place: corners e = 2^-q · lines / 2 + 2^-(f + 1) (GP8), the slope
/// 2^-(f + 1) and what the corners do to it, the first place 2^-(f + 1) more (GP13). In floating
/// point with unit round-off u: eight roundings of numbers up to the raster's size, which do not
/// grow with the lines, as x + slope · k is computed anew for each (models/edge_orderer/stepper).
double slope_bound(const Format& format, double slope, int line, int lines);

/// In the order of the formats. Deterministic.
std::vector<Accumulation> measure_accumulation(const AccumulationOptions& options);

}  // namespace cigsim::stability
