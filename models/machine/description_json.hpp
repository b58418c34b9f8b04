// SPDX-License-Identifier: MIT
// The JSON file of a machine description (docs/machine/description.md).
#pragma once

#include <string>
#include <string_view>

#include "models/machine/description.hpp"

namespace cigsim {

/// Throws InputError (file, line, what, what to do) on anything that is not a whole description:
/// unknown keys, missing figures, wrong kinds, values out of range, figures that contradict each
/// other. `file` stands for the file in messages.
MachineDescription parse_machine(std::string_view text, const std::string& file);

}  // namespace cigsim
