// SPDX-License-Identifier: MIT
#include "sim/pipeline/sequencer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace cigsim {
namespace {

// At frame start k, the picture that is in frame 1, 2 or 3 (`behind` 0, 1 or 2), if there is one.
bool in_machine(std::uint32_t k, std::uint32_t behind, std::uint32_t frames) {
  return k >= behind && k - behind < frames;
}

}  // namespace

Sequencer::Sequencer(sc_core::sc_module_name name, Cycle frame_cycles, const Links& links,
                     Calls calls)
    : sc_module(name), frame_cycles_(frame_cycles), links_(links), calls_(std::move(calls)) {
  SC_HAS_PROCESS(Sequencer);
  SC_THREAD(sequence);
}

// F1.
void Sequencer::start(std::uint32_t k, std::uint32_t frames, Cycle at) {
  if (in_machine(k, 0, frames)) links_.start_calculator.push({k}, at);
  if (in_machine(k, 1, frames)) {
    links_.start_priority.push({k - 1}, at);
    links_.start_geometry.push({k - 1}, at);
  }
  if (in_machine(k, 2, frames)) {
    links_.start_orderer.push({k - 2}, at);
    links_.start_video.push({k - 2}, at);
  }
}

// F3. Returns the cycle in which the last completion was taken.
Cycle Sequencer::wait_for_all(std::uint32_t k, std::uint32_t frames, Cycle at) {
  Cycle last = at;
  const auto wait_for = [&last](Link<FrameWord>& link) {
    const Cycle taken = link.available();
    link.take(taken);
    last = std::max(last, taken);
  };
  if (in_machine(k, 0, frames)) wait_for(links_.calculated);
  if (in_machine(k, 1, frames)) {
    wait_for(links_.edges_loaded);
    wait_for(links_.faces_loaded);
  }
  if (in_machine(k, 2, frames)) wait_for(links_.shown);
  return last;
}

void Sequencer::sequence() {
  std::uint32_t frames = std::numeric_limits<std::uint32_t>::max();
  Cycle at = 0;
  for (std::uint32_t k = 0; k < frames || in_machine(k, 1, frames) || in_machine(k, 2, frames);
       ++k) {
    if (k < frames && !calls_.next(k)) {
      frames = k;
      if (!in_machine(k, 1, frames) && !in_machine(k, 2, frames)) break;
    }
    if (calls_.started) calls_.started(k, at);
    start(k, frames, at);
    at = std::max(at + frame_cycles_, wait_for_all(k, frames, at) + 1);
  }
  calls_.finished();
}

}  // namespace cigsim
