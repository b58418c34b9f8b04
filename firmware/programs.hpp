// SPDX-License-Identifier: MIT
// The microprograms that the library carries: firmware/STAGE/format.fmt and microprogram.mas.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "firmware/assembler/program.hpp"

namespace cigsim::firmware {

/// Stages that are microcoded: "priority_processor", …
std::vector<std::string> microcoded_stages();

/// Throws std::invalid_argument for a stage that is not microcoded, naming those that are.
Format stage_format(std::string_view stage);

/// The stage's microprogram, with constants set anew. Throws as `assemble` and `stage_format`.
Program stage_program(std::string_view stage, const Overrides& overrides = {});

}  // namespace cigsim::firmware
