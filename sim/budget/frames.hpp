// SPDX-License-Identifier: MIT
// Which frames of a run are measured before it, and which are held back to check the choice.
#pragma once

#include <cstddef>
#include <vector>

namespace cigsim {

struct FrameSample {
  std::vector<std::size_t> sampled;    ///< spread over the run, ascending; at least one
  std::vector<std::size_t> held_back;  ///< none of those, ascending; none where all are sampled
};

/// Of `frames` frames at most `most` each, and no more than half of them (rounded up) sampled.
/// Neither may be 0.
FrameSample sample_frames(std::size_t frames, std::size_t most);

}  // namespace cigsim
