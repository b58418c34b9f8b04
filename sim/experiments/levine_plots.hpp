// SPDX-License-Identifier: MIT
// The graphs that Levine 1975 prints in his appendices.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/experiments/levine_findings.hpp"

namespace cigsim {

/// Writes them into `folder`, which exists, and returns the files' names: of the hull a sheet of
/// averages for each of his two groups and one of histograms, the same of the sphere with its four
/// shares, of the hidden lines the averages against edges and the frames of the city. Throws
/// InputError when gnuplot is missing.
std::vector<std::filesystem::path> write_levine_plots(const LevineResults& results,
                                                      const std::filesystem::path& folder);

}  // namespace cigsim
