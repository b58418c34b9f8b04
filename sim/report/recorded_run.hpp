// SPDX-License-Identifier: MIT
// A run as its stats.json tells of it: all that it takes to compute its frames again.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/functional_machine.hpp"
#include "sim/scene.hpp"
#include "sim/view.hpp"

namespace cigsim {

struct RecordedFrame {
  FrameView view;
  std::string picture, ids;        ///< file names, beside stats.json
  std::size_t faces = 0;           ///< on the raster
  nlohmann::ordered_json figures;  ///< the frame's entry of stats.json
};

struct RecordedRun {
  std::string scene;                      ///< as named when it ran
  std::optional<std::string> scene_file;  ///< none: the built-in airfield
  MachineOptions machine;                 ///< gives the run's results at the functional level
  PreparationChoices preparation;
  std::vector<RecordedFrame> frames;
  nlohmann::ordered_json stats;  ///< all of it but the frames
};

/// Throws InputError, naming the file and the line, when it is missing or no run's.
RecordedRun read_recorded_run(const std::filesystem::path& stats_file);

}  // namespace cigsim
