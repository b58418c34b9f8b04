// SPDX-License-Identifier: MIT
// Levine's measurements of his convex hull (1975, ch. VII and app. I), repeated.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "models/environment/point_sets.hpp"
#include "sim/experiments/statistics.hpp"

namespace cigsim {

struct ExperimentOptions {
  std::uint32_t cases = kPointSetCases;  ///< of each data set, at least 1
  std::uint64_t seed = 1;
  /// Called now and then with a share of the work in 0..1.
  std::function<void(double)> progress;
};

/// One data set: a distribution and a number of points. A value a case.
struct HullDataSet {
  std::uint32_t points = 0;                  ///< NPTS
  std::vector<double> hull_points;           ///< NPTH
  std::vector<double> tests;                 ///< NT
  std::vector<double> equivalent_tests;      ///< NEQ, of Chand and Kapur
  std::vector<double> tests_per_point;       ///< NT/NPTH
  std::vector<double> equivalent_per_point;  ///< NEQ/NPTH
  double seconds = 0;                        ///< all cases, hull alone
};

struct HullCurve {
  PointDistribution distribution{};
  std::vector<HullDataSet> sets;  ///< ascending numbers of points
};

using HullQuantity = std::vector<double> HullDataSet::*;

struct NamedHullQuantity {
  const char* key;
  const char* letters;  ///< Levine's
  HullQuantity values;
};

/// What he recorded, in the order of his appendix.
inline constexpr NamedHullQuantity kHullQuantities[] = {
    {"hull_points", "NPTH", &HullDataSet::hull_points},
    {"tests", "NT", &HullDataSet::tests},
    {"equivalent_tests", "NEQ", &HullDataSet::equivalent_tests},
    {"tests_per_hull_point", "NT/NPTH", &HullDataSet::tests_per_point},
    {"equivalent_tests_per_hull_point", "NEQ/NPTH", &HullDataSet::equivalent_per_point}};

/// All eight distributions at his numbers of points.
std::vector<HullCurve> run_hull_experiment(const ExperimentOptions& options);

/// Averages against the number of points.
std::vector<Vec2> averages(const HullCurve& curve, HullQuantity quantity);

}  // namespace cigsim
