// SPDX-License-Identifier: MIT
// Experiments in a folder as data of the page: their figures and their drawings.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cigsim {

/// {"experiments": [{"file", "figures"}], "drawings": [{"file", "uri"}], "notes": [words]}: every
/// NAME.json of the folder that tells of an experiment, and every NAME.svg, by name. Others are
/// noted, and so is what is broken or cannot be read, with its line. Throws InputError when the
/// folder cannot be read.
nlohmann::ordered_json experiment_section(const std::filesystem::path& folder);

}  // namespace cigsim
