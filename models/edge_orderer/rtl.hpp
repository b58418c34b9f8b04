// SPDX-License-Identifier: MIT
// Edge orderer, RTL level: rtl/edge_orderer, Verilated, behind the pins of the clocked level. The
// RTL orders the crossings; the figures are counted here, from the pins.
#pragma once

#include <array>
#include <filesystem>
#include <systemc>

#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/rtl_model.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/edge_orderer/figures.hpp"
#include "models/machine/description.hpp"

namespace cigsim::edge_orderer {

class Rtl : public sc_core::sc_module {
 public:
  /// As Clocked. `library` is edge_orderer of some Edges, Lines and Crossings; a picture that has
  /// more than they hold ends the simulation with a std::runtime_error. `seed`, not zero: what
  /// registers without reset begin with.
  Rtl(sc_core::sc_module_name name, const MachineDescription& machine, OverloadPolicy policy,
      const Clock& time, const std::filesystem::path& library, FiguresFunction figures = {},
      std::uint32_t seed = 1);

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<EdgeWord> edges{"edges"};
  PinOut<FrameWord> loaded{"loaded"};
  PinIn<FrameWord> start{"start"};
  PinOut<CrossingWord> crossings{"crossings"};

  void trace(sc_core::sc_trace_file* file);
  RtlModel& model() { return model_; }

 private:
  void edge();
  void drive();
  void show();
  void count(Cycle now);
  void count_filling();
  void count_draining(Cycle now);

  const Clock& time_;
  FiguresFunction report_;
  std::uint32_t height_;
  RtlModel model_;

  std::uint32_t load_frame_ = 0;
  std::array<std::uint64_t, 2> loaded_edges_{};  ///< by the parity of the picture
  std::uint32_t fill_line_ = 0, drain_line_ = 0;
  Figures figures_;
};

}  // namespace cigsim::edge_orderer
