// SPDX-License-Identifier: MIT
// The summaries that Levine 1975 makes of his measurements (app. I and II).
#pragma once

#include <span>
#include <vector>

#include "models/numeric/orientation2.hpp"

namespace cigsim {

/// 0 without values.
double mean(std::span<const double> values);

/// The largest value of the smallest `share` of them (0 < share <= 1): of 500 values sorted, the
/// 250th for one half. Infinity is a value. 0 without values.
double percentile(std::vector<double> values, double share);

/// y = 10^intercept x^exponent.
struct PowerFit {
  double exponent = 0, intercept = 0;
  std::size_t points = 0;  ///< that were used; without two there is no fit
};

/// Least squares on the decimal logarithms of the last `last` points (his: four) whose coordinates
/// are finite and positive.
PowerFit power_fit(std::span<const Vec2> points, std::size_t last = 4);

/// y = offset + slope x by least squares; no fit (zeros) without two different x.
struct LineFit {
  double slope = 0, offset = 0;
  double correlation = 0;  ///< Pearson's, 1 on a rising line
};
LineFit line_fit(std::span<const Vec2> points);

/// Counts in up to `bins` classes of equal width, as middle of class and count. Values that are not
/// finite are left out. Whole numbers in a narrow range get a class each.
std::vector<Vec2> histogram(std::span<const double> values, std::size_t bins = 40);

}  // namespace cigsim
