// SPDX-License-Identifier: MIT
// Priority processor, timed level (docs/machine/priority_processor.md): a process that gives the
// list in exact cycles, without a clock. What its steps cost is in the microprogram.
#pragma once

#include <array>
#include <systemc>

#include "models/boundary/link.hpp"
#include "models/boundary/words.hpp"
#include "models/machine/description.hpp"
#include "models/priority_processor/list_walk.hpp"

namespace cigsim::priority_processor {

class Timed : public sc_core::sc_module {
 public:
  struct Links {
    Link<FrameWord>& start;
    Link<ItemWord>& items;
  };

  /// Reads the bank of the frame's parity, from the start word to the end word. `figures`, which
  /// may be empty, is called once a frame.
  Timed(sc_core::sc_module_name name, const MachineDescription& machine, Links links,
        const std::array<PriorityBank, 2>& banks, FiguresFunction figures = {});

 private:
  /// Moves the cycle on with the steps of the walk.
  struct Pace {
    void spend(Step step, std::uint64_t times = 1) {
      now += cost[static_cast<std::size_t>(step)] * static_cast<Cycle>(times);
    }
    void put(const ItemWord& item);

    Link<ItemWord>& out;
    std::array<Cycle, static_cast<std::size_t>(Step::kCount)> cost{};
    Cycle now = 0;
    Cycle stalled = 0;
  };

  void run();
  void frame();

  Link<FrameWord>& start_;
  const std::array<PriorityBank, 2>& banks_;
  std::uint32_t capacity_;
  FiguresFunction report_;
  Pace pace_;
  ListWalk<Pace> walk_;
  Cycle take_ = 0, end_ = 0, finish_ = 0;  // costs
  Cycle free_ = 0;                         // from this cycle on a start word can be taken
  Figures figures_;
};

}  // namespace cigsim::priority_processor
