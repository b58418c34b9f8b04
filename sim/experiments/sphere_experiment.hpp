// SPDX-License-Identifier: MIT
// Levine's measurements of his search for the smallest sphere (1975, ch. VII and app. II),
// repeated.
#pragma once

#include <array>
#include <vector>

#include "sim/experiments/hull_experiment.hpp"

namespace cigsim {

/// A value a case; infinity where the search gave up at point 26, as Levine's did.
struct SphereDataSet {
  std::uint32_t points = 0;                          ///< NPTS
  std::vector<double> tests;                         ///< NT
  std::vector<double> tests_per_point;               ///< NT/NPTH
  std::vector<double> spheres_created;               ///< NSC
  std::vector<double> spheres_tested;                ///< NST
  std::vector<double> spheres_expected;              ///< ESC; never infinite
  std::vector<double> first, second, third, fourth;  ///< SP; only cases that have such a point
  std::array<std::uint32_t, 5> types{};  ///< TSC: cases by the number of points of the sphere
  std::uint32_t given_up = 0;
  double seconds = 0;  ///< all cases, hull and sphere
};

struct SphereCurve {
  PointDistribution distribution{};
  std::vector<SphereDataSet> sets;
};

using SphereQuantity = std::vector<double> SphereDataSet::*;

struct NamedSphereQuantity {
  const char* key;
  const char* letters;
  SphereQuantity values;
};

inline constexpr NamedSphereQuantity kSphereQuantities[] = {
    {"tests", "NT", &SphereDataSet::tests},
    {"tests_per_hull_point", "NT/NPTH", &SphereDataSet::tests_per_point},
    {"spheres_created", "NSC", &SphereDataSet::spheres_created},
    {"spheres_tested", "NST", &SphereDataSet::spheres_tested},
    {"spheres_expected", "ESC", &SphereDataSet::spheres_expected},
    {"selected_point_1", "SP 1", &SphereDataSet::first},
    {"selected_point_2", "SP 2", &SphereDataSet::second},
    {"selected_point_3", "SP 3", &SphereDataSet::third},
    {"selected_point_4", "SP 4", &SphereDataSet::fourth}};

/// The shares of his four curves.
inline constexpr std::array<double, 4> kSphereShares{0.5, 0.6, 0.7, 0.8};

std::vector<SphereCurve> run_sphere_experiment(const ExperimentOptions& options);

/// The value that `share` of the cases do not exceed, against the number of points; sets
/// without such a value are left out.
std::vector<Vec2> percentiles(const SphereCurve& curve, SphereQuantity quantity, double share);

}  // namespace cigsim
