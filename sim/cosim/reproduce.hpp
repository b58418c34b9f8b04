// SPDX-License-Identifier: MIT
// From a mismatch to a replay file with as few frames as show it again, and a wave of it.
#pragma once

#include <filesystem>
#include <string>

#include "sim/cosim/replay_file.hpp"
#include "sim/wave/wave_options.hpp"

namespace cigsim::cosim {

/// Shortest first: the frame alone, with the two before it, all up to it. Each try is a process of
/// its own, `cigsim replay`, because SystemC simulates once a process. Writes `file` with the
/// difference as the replay sees it, and returns whether it was seen again; if not, the file has
/// all frames.
bool write_shortest_replay(FrameReplay replay, const std::filesystem::path& file);

/// The cycles to record: from shortly before the difference to shortly after.
CycleWindow window_around(Cycle cycle);
/// How long a replay goes on after the difference.
inline constexpr Cycle kCyclesAfter = 24;

}  // namespace cigsim::cosim
