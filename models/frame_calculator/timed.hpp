// SPDX-License-Identifier: MIT
// Frame calculator, timed level (docs/machine/frame_calculator.md): a general-purpose computer
// whose time on a frame follows from how much it has to do. The costs are reconstruction.
#pragma once

#include <functional>
#include <systemc>

#include "models/boundary/activity.hpp"
#include "models/boundary/link.hpp"
#include "models/boundary/words.hpp"
#include "models/frame_calculator/work.hpp"
#include "models/machine/description.hpp"

namespace cigsim::frame_calculator {

struct Figures : StageFigures {
  std::uint64_t spheres = 0, vertices = 0;
  friend bool operator==(const Figures&, const Figures&) = default;
};

class Timed : public sc_core::sc_module {
 public:
  struct Links {
    Link<FrameWord>& start;       ///< from the sequencer
    Link<FrameWord>& calculated;  ///< to the sequencer
  };
  /// Calculates a frame into the banks of its parity.
  using Calculate = std::function<Work(std::uint32_t frame)>;

  Timed(sc_core::sc_module_name name, const MachineDescription& machine, const Links& links,
        Calculate calculate, std::function<void(const Figures&)> report);

 private:
  void run();

  MachineDescription::FrameCalculatorCosts costs_;
  Links links_;
  Calculate calculate_;
  std::function<void(const Figures&)> report_;
};

}  // namespace cigsim::frame_calculator
