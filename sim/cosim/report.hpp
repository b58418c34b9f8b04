// SPDX-License-Identifier: MIT
// What a comparison found, as lines for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "models/boundary/mismatch.hpp"
#include "sim/cosim/so_vectors.hpp"

namespace cigsim::cosim {

/// Frame, line, cycle, stage, field, what was expected, what was got, and the inputs.
std::vector<std::string> mismatch_lines(const Mismatch& mismatch);
std::vector<std::string> mismatch_lines(const SoMismatch& mismatch);

nlohmann::ordered_json mismatch_json(const Mismatch& mismatch);

/// One line.
std::string summary(const SoMismatch& mismatch);

}  // namespace cigsim::cosim
