// SPDX-License-Identifier: MIT
// The command's machine options: which machine, at which levels, on which numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "sim/functional_machine.hpp"
#include "sim/level.hpp"

namespace cigsim {

/// As given on the command line.
struct MachineChoices {
  std::optional<std::string> machine;  ///< a preset or a file
  std::optional<NumberType> number;
  std::optional<ResolverMethod> resolver;
  PriorityMethod priority = PriorityMethod::kCounters;
  std::optional<OverloadPolicy> overload;
  double detail = 1;                         ///< MachineOptions::detail
  std::optional<bool> retrieval, coherence;  ///< none: on where they are a choice
  LevelChoice levels;
};

/// Those of them that describe the machine: --machine and --overload.
void add_description_options(CLI::App& command, MachineChoices& choices);
void add_machine_options(CLI::App& command, MachineChoices& choices);

/// What the choices mean together. Without --raster the machine's own raster is taken. Throws
/// UsageError where they contradict each other, InputError for an unusable description.
MachineOptions machine_options(const MachineChoices& choices, const std::optional<Raster>& raster);

}  // namespace cigsim
