// SPDX-License-Identifier: MIT
// How much the frame calculator has to do for a frame.
#pragma once

#include <cstdint>
#include <vector>

namespace cigsim::frame_calculator {

struct Work {
  std::uint64_t spheres = 0;   ///< members of active groups, tested against the pyramid of vision
  std::uint64_t vertices = 0;  ///< of moving models, placed
  std::uint64_t overflows = 0;
  std::vector<std::uint32_t> detail;  ///< ActiveEnvironment::detail
};

}  // namespace cigsim::frame_calculator
