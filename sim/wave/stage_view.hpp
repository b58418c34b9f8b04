// SPDX-License-Identifier: MIT
// The saved views of waves/ for a wave file: those of the RTL where the file has RTL signals, with
// the ranges that signals have in the file, as GTKWave wants them; below it that of a clocked twin,
// where the wave is of a comparison.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/wave/wave.hpp"

namespace cigsim {

struct StageView {
  std::string text;             ///< without the heading lines and the clock of the file in waves/
  std::set<std::string> names;  ///< the files of waves/ with names of values that it uses
};

/// `signals`: those of the wave file. `folder`, which ends like a path that a file name is put
/// behind: where the files with names will stand.
StageView stage_view(std::string_view stage, const std::vector<WaveSignal>& signals,
                     const std::string& folder);

}  // namespace cigsim
