// SPDX-License-Identifier: MIT
// What a sweep found: as JSON, as a short table, as heat maps.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/drawing/gnuplot.hpp"
#include "sim/stability/sweep.hpp"

namespace cigsim::stability {

/// {"decisions": […], "formats": […], "trials": N}: every cell, the first failure of each axis and
/// the first broken claim, with their instances. docs/schemas/stability.schema.json has the keys.
nlohmann::ordered_json sweep_json(const SweepPlan& plan, const Sweep& sweep);

/// A line a decision: where each format is wrong most often; then the claims that did not hold.
std::string sweep_text(const SweepPlan& plan, const Sweep& sweep);

/// stability.svg (decisions by formats, the worst share of each) and of each axis
/// stability-AXIS.svg (decisions by values, a map a format).
std::vector<Sheet> sweep_maps(const SweepPlan& plan, const Sweep& sweep);

}  // namespace cigsim::stability
