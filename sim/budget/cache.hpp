// SPDX-License-Identifier: MIT
// Evidence of earlier runs, in files named after all that it depends on.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "models/database/database.hpp"
#include "sim/budget/evidence.hpp"
#include "sim/measure/setting.hpp"
#include "sim/view.hpp"

namespace cigsim {

/// Where evidence is kept: the folder that CIGSIM_BUDGET_CACHE names (default: cigsim/budget in the
/// user's cache folder).
std::filesystem::path budget_cache_folder();

/// All that the evidence of `settings` depends on: what the database holds, the sampled views, the
/// settings, the program itself, and the processor that the times are of.
nlohmann::ordered_json evidence_key(const Database& database, const std::vector<FrameView>& views,
                                    const std::vector<Setting>& settings, Level referee);

/// The file that holds evidence of this key, or would.
std::filesystem::path evidence_file(const nlohmann::ordered_json& key);

/// Nothing where there is none, or what is there is not whole.
std::optional<std::vector<Evidence>> read_evidence(const std::filesystem::path& file,
                                                   const nlohmann::ordered_json& key);

/// Whole or not at all. Throws InputError when it cannot be written.
void write_evidence(const std::filesystem::path& file, const nlohmann::ordered_json& key,
                    const std::vector<Evidence>& evidence);

}  // namespace cigsim
