// SPDX-License-Identifier: MIT
// What cigsim separate finds, as a report in the layout of Stump's (1986, Figs. 10, 13 and 17) and
// as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "models/database/separation_planes/published.hpp"
#include "models/database/separation_planes/separate.hpp"

namespace cigsim {

/// His lines, with normals and distances in full, then what was found besides.
std::string separation_report(const separation_planes::SeparationResult& result);

nlohmann::ordered_json to_json(const separation_planes::SeparationResult& result);
nlohmann::ordered_json to_json(const separation_planes::PublishedTable& table);

}  // namespace cigsim
