// SPDX-License-Identifier: MIT
// What Levine 1975 says of his measurements in words and figures, beside ours.
#pragma once

#include <string>
#include <vector>

#include "sim/experiments/hidden_line_experiment.hpp"
#include "sim/experiments/sphere_experiment.hpp"

namespace cigsim {

/// A part that was left out is empty.
struct LevineResults {
  ExperimentOptions options;
  std::vector<HullCurve> hull;
  std::vector<SphereCurve> sphere;
  std::vector<HiddenLineDataSet> hidden_line;
};

struct Finding {
  std::string what;
  std::string published;  ///< in short
  double ours = 0;
  double low = 0, high = 0;  ///< what agrees with the published words
  bool timed = false;        ///< depends on the host
  bool agrees() const { return low <= ours && ours <= high; }
};

std::vector<Finding> levine_findings(const LevineResults& results);

}  // namespace cigsim
