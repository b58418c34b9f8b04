// SPDX-License-Identifier: MIT
// Priority resolver, RTL level: rtl/priority_resolver, Verilated, behind the pins of the clocked
// level. The RTL makes the spans; the figures are counted here, from the pins.
#pragma once

#include <filesystem>
#include <systemc>

#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/rtl_model.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/machine/description.hpp"
#include "models/priority_resolver/figures.hpp"

namespace cigsim::priority_resolver {

class Rtl : public sc_core::sc_module {
 public:
  /// As Clocked. `library` is priority_resolver of some Faces; a face number beyond them ends the
  /// simulation with a std::runtime_error. `seed`, not zero: what registers without reset begin
  /// with.
  Rtl(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
      const std::filesystem::path& library, FiguresFunction figures = {}, std::uint32_t seed = 1);

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<CrossingWord> crossings{"crossings"};
  PinOut<SpanWord> spans{"spans"};

  void trace(sc_core::sc_trace_file* file);
  RtlModel& model() { return model_; }

 private:
  void drive();
  void edge();
  void set_ready();
  void count(Cycle now);
  void count_span(Cycle now);
  void finish(Cycle now);

  const Clock& time_;
  FiguresFunction report_;
  std::uint32_t height_;
  RtlModel model_;
  sc_core::sc_event outputs_;  // crossings.ready may have changed

  bool in_frame_ = false;
  std::uint32_t line_ = 0, line_spans_ = 0, active_count_ = 0;
  Cycle busy_ = 0;
  Figures figures_;
};

}  // namespace cigsim::priority_resolver
