// SPDX-License-Identifier: MIT
// The growth experiment as JSON and as plots.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/drawing/gnuplot.hpp"
#include "sim/experiments/growth.hpp"

namespace cigsim {

/// The same seed gives the same text, but for what stands under "host" and in keys that end in
/// "_ms" or "_s".
nlohmann::ordered_json growth_json(const GrowthResults& results);

/// All curves on logarithmic axes: growth.svg.
Sheet growth_sheet(const GrowthResults& results);

}  // namespace cigsim
