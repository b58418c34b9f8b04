// SPDX-License-Identifier: MIT
// The folder of --out of an experiment: its figures as JSON, and drawings of them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/drawing/gnuplot.hpp"

namespace cigsim {

class ExperimentFolder {
 public:
  /// Before the experiment measures: makes the folder for what has `experiment` under "experiment".
  /// Throws UsageError where that is impossible, nothing can be written into it, NAME.json stands
  /// there and is not of an earlier run (perhaps it is the scene), or gnuplot is missing.
  ExperimentFolder(std::filesystem::path folder, const std::string& experiment);

  /// Writes NAME.json with the names of the sheets under "plots", and draws these. The plots that
  /// an earlier run lists are removed, so that none stands beside figures that are not its own;
  /// nothing else in the folder is touched. When a plot cannot be removed or drawn, the figures and
  /// all other plots are written all the same. Returns the files. Throws InputError.
  std::vector<std::filesystem::path> write(nlohmann::ordered_json figures,
                                           const std::vector<Sheet>& sheets) const;

 private:
  std::filesystem::path folder_, figures_;
  std::vector<std::string> earlier_;  ///< plots
};

/// A line a file on the terminal; none where the output is JSON.
void tell_written(const std::vector<std::filesystem::path>& files, bool json);

}  // namespace cigsim
