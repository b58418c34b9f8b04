// SPDX-License-Identifier: MIT
// The report of a folder: one page for a run, for experiments, or for both.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "sim/report/run_section.hpp"

namespace cigsim {

struct ReportOptions {
  std::filesystem::path folder;  ///< holds stats.json of a run, or JSON and SVG of experiments
  std::filesystem::path file;    ///< the page to be written
  RunSectionOptions run;
};

struct Report {
  std::size_t frames = 0, frames_of = 0;  ///< in the page, and in the run
  std::size_t experiments = 0, drawings = 0;
  std::uintmax_t bytes = 0;  ///< of the page
  std::vector<std::string> notes;
};

/// Throws InputError when the folder holds neither, or something broken.
Report write_report(const ReportOptions& options);

}  // namespace cigsim
