// SPDX-License-Identifier: MIT
// Listability faults of a run in words.
#pragma once

#include <string>
#include <vector>

#include "sim/stats.hpp"

namespace cigsim {

/// Every fault once, a line each: its circuit or its unresolved pairs, in how many frames it occurs
/// and in which first. Beyond the first eight a last line tells how many more there are.
std::vector<std::string> fault_lines(const std::vector<FrameRecord>& frames);

}  // namespace cigsim
