// SPDX-License-Identifier: MIT
// Priority processor, RTL level: rtl/priority_processor, Verilated, behind the pins of the clocked
// level. It executes the image of firmware/priority_processor; the database memory and the banks
// are read here, at the addresses that its pins tell, and the figures are counted here.
#pragma once

#include <array>
#include <filesystem>
#include <systemc>

#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/rtl_model.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/machine/description.hpp"
#include "models/priority_processor/figures.hpp"
#include "models/priority_processor/memory.hpp"

namespace cigsim::priority_processor {

class Rtl : public sc_core::sc_module {
 public:
  /// As Clocked. `library` is priority_processor of some Members and Levels; a group of more
  /// members, or a deeper one, ends the simulation with a std::runtime_error. `seed`, not zero:
  /// what registers without reset begin with. Throws std::runtime_error when the library cannot be
  /// loaded or its control store is too small for the microprogram.
  Rtl(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
      const std::array<PriorityBank, 2>& banks, const std::filesystem::path& library,
      FiguresFunction figures = {}, std::uint32_t seed = 1);

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<FrameWord> start{"start"};
  PinOut<ItemWord> items{"items"};

  /// The pins; call it when they are bound and elaboration is done.
  void trace(sc_core::sc_trace_file* file);
  RtlModel& model() { return model_; }

 private:
  void drive();
  void reset();
  void edge();
  void read_memories();
  void count();

  const Clock& time_;
  const std::array<PriorityBank, 2>& banks_;
  FiguresFunction report_;
  RtlModel model_;
  bool valid_ = false, ready_ = false;  // what the outputs are
  Figures figures_;
};

}  // namespace cigsim::priority_processor
