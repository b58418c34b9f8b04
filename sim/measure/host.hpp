// SPDX-License-Identifier: MIT
// The computer that a measurement ran on.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace cigsim {

/// The processor's name as the system tells it; its architecture where it tells none.
std::string processor_name();

/// {"processor": …, "cores": …}: what the times of an experiment depend on.
nlohmann::ordered_json host_json();

}  // namespace cigsim
