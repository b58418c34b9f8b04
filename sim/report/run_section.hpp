// SPDX-License-Identifier: MIT
// A run as data of the page.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "sim/report/recorded_run.hpp"

namespace cigsim {

struct RunSectionOptions {
  std::size_t frames = 12;  ///< at most so many, spread over the run; at least 1
  bool difference = true;   ///< against the exact pictures
  std::function<void(double)> progress;
};

/// The run's figures, all of them for the frames that are shown, with pictures as data URIs and
/// faces (faces_json.hpp); "notes" say what had to be left out. `folder` holds the pictures.
/// Throws InputError when they are missing.
nlohmann::ordered_json run_section(const RecordedRun& run, const std::filesystem::path& folder,
                                   const RunSectionOptions& options);

}  // namespace cigsim
