// SPDX-License-Identifier: MIT
// --stuck: a fault on purpose, so that one sees that a comparison finds it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "models/boundary/stuck_bit.hpp"
#include "sim/cosim/so_vectors.hpp"
#include "sim/level.hpp"

namespace cigsim::cosim {

/// On a stage's pins, or on those of the SO engine.
using StuckChoice = std::variant<std::pair<Stage, StuckBit>, SoStuckBit>;

/// From "STAGE.PINS.FIELD:BIT=0|1" or "so_engine.PIN:BIT=0|1"; ":BIT" may be missing for bit 0.
/// Throws UsageError, naming what there is.
StuckChoice parse_stuck(const std::string& text);

}  // namespace cigsim::cosim
