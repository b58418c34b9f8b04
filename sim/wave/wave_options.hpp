// SPDX-License-Identifier: MIT
// The options of `cigsim run` for waves: which stages, which cycles, into which file.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/level.hpp"
#include "sim/wave/recorder.hpp"

namespace cigsim {

/// As given on the command line.
struct WaveChoices {
  std::optional<std::string> file;
  CycleWindow window;
  std::vector<Stage> scopes;
};

/// What is to be recorded.
struct WaveRequest {
  std::string file;  ///< .vcd or .fst
  CycleWindow window;
  std::vector<Stage> stages;  ///< with pins, in the pipeline's order
  /// Where the saved view opens, with its marker.
  struct Spot {
    Cycle cycle = 0;
    double cycle_ns = 0;
  };
  std::optional<Spot> spot;
};

void add_wave_options(CLI::App& command, WaveChoices& choices);

/// What the choices mean at these levels; nothing without --wave. Throws UsageError where no stage,
/// or not the stage asked for, is clocked, and where the program for .fst files is missing.
std::optional<WaveRequest> wave_request(const WaveChoices& choices, const LevelChoice& levels);

}  // namespace cigsim
