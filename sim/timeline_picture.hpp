// SPDX-License-Identifier: MIT
// The pipeline as a picture: which stage works on which picture when, and the transport delay.
#pragma once

#include <string>
#include <vector>

#include "sim/frame_stats.hpp"

namespace cigsim {

/// An SVG of the first pictures of a run. `clock_ns` gives the time axis. At least one timing.
std::string timeline_svg(const std::vector<FrameTiming>& pictures, double clock_ns);

}  // namespace cigsim
