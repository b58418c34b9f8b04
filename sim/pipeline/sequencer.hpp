// SPDX-License-Identifier: MIT
// The frame sequencer (docs/machine.md, "Frames"): starts the three frames that overlap, and the
// next ones when their time has come and all is done.
#pragma once

#include <cstdint>
#include <functional>
#include <systemc>

#include "models/boundary/link.hpp"
#include "models/boundary/words.hpp"

namespace cigsim {

class Sequencer : public sc_core::sc_module {
 public:
  struct Links {
    Link<FrameWord>&start_calculator, &start_priority, &start_geometry, &start_orderer,
        &start_video;
    Link<FrameWord>&calculated, &edges_loaded, &faces_loaded, &shown;
  };
  struct Calls {
    /// Frame `frame` is to be calculated; false: there is none, the run ends with those before.
    std::function<bool(std::uint32_t frame)> next;
    /// Frame start k happened in that cycle.
    std::function<void(std::uint32_t k, Cycle cycle)> started;
    /// All pictures are out.
    std::function<void()> finished;
  };

  /// `frame_cycles`: from one frame start to the next at least.
  Sequencer(sc_core::sc_module_name name, Cycle frame_cycles, const Links& links, Calls calls);

 private:
  void sequence();
  void start(std::uint32_t k, std::uint32_t frames, Cycle at);
  Cycle wait_for_all(std::uint32_t k, std::uint32_t frames, Cycle at);

  Cycle frame_cycles_;
  Links links_;
  Calls calls_;
};

}  // namespace cigsim
