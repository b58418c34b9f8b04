// SPDX-License-Identifier: MIT
// The graphs that Levine 1975 prints in his appendices.
#pragma once

#include <vector>

#include "sim/drawing/gnuplot.hpp"
#include "sim/experiments/levine_findings.hpp"

namespace cigsim {

/// Of the hull a sheet of averages for each of his two groups and one of histograms, the same of
/// the sphere with its four shares, of the hidden lines the averages against edges and the frames
/// of the city; each of what was measured.
std::vector<Sheet> levine_sheets(const LevineResults& results);

}  // namespace cigsim
