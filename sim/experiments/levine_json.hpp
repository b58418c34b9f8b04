// SPDX-License-Identifier: MIT
// Levine's measurements, repeated, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/experiments/levine_findings.hpp"

namespace cigsim {

/// "findings", and "hull", "sphere", "hidden_line" where they were run. But for the times
/// ("seconds", "ms", and findings with "timed") the same cases and seed give the same text. Values
/// that are not finite (a search that gave up) are null.
nlohmann::ordered_json levine_json(const LevineResults& results);

}  // namespace cigsim
