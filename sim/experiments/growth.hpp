// SPDX-License-Identifier: MIT
// What a frame and its preparation cost against the size of what they work on: objects out of view
// and in view, planes, edges, elements of the raster; each with the exponent of a power law through
// the largest sizes beside the one that is to be expected, and the reason.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/experiments/statistics.hpp"
#include "sim/measure/interleave.hpp"

namespace cigsim {

struct GrowthOptions {
  bool quick = false;  ///< small sizes, for tests
  std::uint32_t most_objects =
      1000000;             ///< of the curves out of view; those in view end at a tenth
  std::uint64_t seed = 1;  ///< of the scenes and of the order of measurements
  /// Told the share of the work that is done, and what comes next.
  std::function<void(double, const std::string&)> progress;
};

struct GrowthPoint {
  double x = 0;
  Spread y;  ///< of what is counted only the median, without spread
};

/// The exponents that agree with theory, and the one in the middle of it.
struct ExpectedExponent {
  double exponent = 0, low = 0, high = 0;
};

struct GrowthCurve {
  std::string sweep;     ///< what grows: "objects out of view"
  std::string quantity;  ///< and what with it, with its unit: "frame, ms"
  std::string key;       ///< for files: letters and underlines
  std::string why;       ///< the floor, in words
  bool timed = false;    ///< depends on the host
  ExpectedExponent expected;
  std::vector<GrowthPoint> points = {};

  std::vector<Vec2> medians() const;
  PowerFit fit() const { return power_fit(medians()); }  ///< through the last four
  bool as_expected() const;
  /// It is timed, or grows as expected.
  bool holds() const;
};

struct GrowthResults {
  GrowthOptions options;
  std::vector<GrowthCurve> curves;
  bool same_pictures = true;  ///< whatever stands out of view

  /// Pictures are the same, and every curve holds.
  bool good() const;
};

/// All sweeps. Throws std::bad_alloc where the largest environment does not fit into the memory.
GrowthResults run_growth(const GrowthOptions& options);

}  // namespace cigsim
