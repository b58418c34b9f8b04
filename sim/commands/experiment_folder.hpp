// SPDX-License-Identifier: MIT
// The folder of --out of an experiment: its figures as JSON, and drawings of them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/drawing/gnuplot.hpp"

namespace cigsim {

/// Makes the folder. Throws UsageError where that is impossible, nothing can be written into it, or
/// gnuplot is missing, which draws.
void make_out_folder(const std::string& folder);

/// Writes NAME.json, where NAME is what `figures` have under "experiment", with the names of the
/// sheets under "plots"; then draws these. In between it removes the plots that the NAME.json of an
/// earlier run lists, so that none stands beside figures that are not its own; nothing else in the
/// folder is touched. Figures stay when drawing fails. Returns the files. Throws InputError.
std::vector<std::filesystem::path> write_experiment(nlohmann::ordered_json figures,
                                                    const std::vector<Sheet>& sheets,
                                                    const std::filesystem::path& folder);

}  // namespace cigsim
