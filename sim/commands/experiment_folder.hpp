// SPDX-License-Identifier: MIT
// The folder of --out of an experiment: its figures as JSON, and drawings of them.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/drawing/gnuplot.hpp"

namespace cigsim {

class ExperimentFolder {
 public:
  /// Before the experiment measures: makes the folder for what has `experiment` under "experiment".
  /// None: nothing is to be written. Throws UsageError where that is impossible, nothing can be
  /// written into it, NAME.json stands there and is not of an earlier run (perhaps it is the
  /// scene), or gnuplot is missing.
  ExperimentFolder(const std::optional<std::string>& folder, const std::string& experiment);

  /// Writes NAME.json with the names of the sheets under "plots", and draws these. The plots that
  /// an earlier run lists are removed, so that none stands beside figures that are not its own;
  /// nothing else in the folder is touched. What fails is told by tell(), so that figures can be
  /// printed all the same; whatever else can be written is.
  void write(nlohmann::ordered_json figures, const std::vector<Sheet>& sheets);

  /// A line a file on the terminal; none where the output is JSON. Throws std::runtime_error for
  /// what could not be written.
  void tell(bool json) const;

 private:
  std::filesystem::path folder_, figures_;  ///< empty: nothing is to be written
  std::vector<std::string> earlier_;        ///< plots
  std::vector<std::filesystem::path> written_;
  std::string fault_;  ///< the first

  bool attempt(const std::filesystem::path& file, const std::function<void()>& work);
  bool write_figures(nlohmann::ordered_json& figures, const std::vector<std::string>& plots);
};

}  // namespace cigsim
