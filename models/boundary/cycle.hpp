// SPDX-License-Identifier: MIT
// The machine's time: whole clock cycles from the start of the run. Cycle 0 is the first.
#pragma once

#include <cstdint>

namespace cigsim {

using Cycle = std::int64_t;

}  // namespace cigsim
