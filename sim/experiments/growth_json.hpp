// SPDX-License-Identifier: MIT
// The growth experiment as JSON and as plots.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/experiments/growth.hpp"

namespace cigsim {

/// The same seed gives the same text, but for what stands under "host" and in keys that end in
/// "_ms" or "_s".
nlohmann::ordered_json growth_json(const GrowthResults& results);

/// A sheet of all curves on logarithmic axes, growth.svg in `folder`, which exists. Throws
/// InputError as write_plots().
std::filesystem::path write_growth_plots(const GrowthResults& results,
                                         const std::filesystem::path& folder);

}  // namespace cigsim
