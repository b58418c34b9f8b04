// SPDX-License-Identifier: MIT
// The frames of a run, computed and written.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/stats.hpp"
#include "sim/view.hpp"
#include "sim/wave/wave_options.hpp"

namespace cigsim {

/// Computes `views` on the machine and at the levels that `run` names, writes a picture and a file
/// of object numbers for each into `folder`, and adds their figures to `run`. Where there is a
/// `wave` to record, some stage is clocked. Ctrl-C ends it after the pictures that are in the
/// machine: returns the signal, or 0. Throws InputError when a file cannot be written.
int run_frames(const std::vector<FrameView>& views, const std::filesystem::path& folder,
               const std::optional<WaveRequest>& wave, RunRecord& run);

}  // namespace cigsim
