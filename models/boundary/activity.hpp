// SPDX-License-Identifier: MIT
// What a stage at the timed or clocked level tells about its part of a frame.
#pragma once

#include "models/boundary/cycle.hpp"

namespace cigsim {

/// From the cycle in which the stage took the frame's first word to the one in which its last word
/// was taken from it, both counted. Every cycle in between is busy, idle or stalled; which is which
/// is a rule of the stage's page.
struct Activity {
  Cycle start = 0, finish = 0;
  Cycle idle = 0;     ///< waiting for a word to take
  Cycle stalled = 0;  ///< waiting for its own word to be taken
  Cycle busy() const { return finish - start + 1 - idle - stalled; }
  friend bool operator==(const Activity&, const Activity&) = default;
};

/// Figures of one frame that every stage has; stages add their own.
struct StageFigures {
  std::uint32_t frame = 0;
  Activity activity;
  std::uint64_t overflows = 0;  ///< words that were saturated
  std::uint64_t dropped = 0;    ///< what did not fit: items, faces, crossings
  friend bool operator==(const StageFigures&, const StageFigures&) = default;
};

}  // namespace cigsim
