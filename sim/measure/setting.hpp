// SPDX-License-Identifier: MIT
// One setting of all the knobs that trade speed for accuracy.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "sim/functional_machine.hpp"
#include "sim/level.hpp"
#include "sim/systemc_machine.hpp"

namespace cigsim {

struct Setting {
  std::string name;
  /// At levels that know time: NumberType::kMachine, and the description's raster is `raster`.
  MachineOptions machine;
  LevelChoice levels;
};

/// The knobs of it, by the names of the command's options; those that machine words do not have are
/// null on them, as the machine's name and word formats are elsewhere.
nlohmann::ordered_json setting_json(const Setting& setting);

/// The same machine with every stage at `level`, or the nearest simpler one that it has; named
/// after the level.
Setting at_level(const Setting& setting, Level level);

/// Whether something in the scene has several levels of detail.
bool has_choices(const Database& database);

/// Of each stage of the setting whose RTL takes part: its library, in the size that the database
/// needs, built if need be. Throws UsageError as rtl_library().
std::map<Stage, std::filesystem::path> rtl_libraries(const Setting& setting,
                                                     const Database& database);

/// The pipeline of a setting whose levels know time, with the libraries that rtl_libraries() found.
PipelineOptions pipeline_options(const Setting& setting,
                                 std::map<Stage, std::filesystem::path> libraries);

}  // namespace cigsim
