// SPDX-License-Identifier: MIT
// Records waves of clocked stages while they run: a window of cycles, and nothing outside it.
#pragma once

#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <systemc>

#include "models/boundary/clock.hpp"
#include "sim/wave/vcd_writer.hpp"

namespace cigsim {

struct CycleWindow {
  Cycle first = 0;
  Cycle last = std::numeric_limits<Cycle>::max();  ///< the last one in it
};

/// Looks at the stages once a cycle, at the falling clock edge, when pins and registers stand for
/// the rest of the cycle. Ahead of the window it sleeps, and after it it does nothing.
class Recorder : public sc_core::sc_module {
 public:
  /// Calls `trace` once when all pins are connected. `clock` names the clock in the wave.
  Recorder(sc_core::sc_module_name name, const Clock& clock, const std::string& clock_name,
           std::ostream& out, const CycleWindow& window,
           std::function<void(sc_core::sc_trace_file*)> trace);

  /// To be called after the simulation, also where it ended within the window or before it.
  void finish();

 private:
  void start_of_simulation() override;
  void look();

  const Clock& clock_;
  VcdWriter writer_;
  CycleWindow window_;
  std::function<void(sc_core::sc_trace_file*)> trace_;
  sc_core::sc_event never_;
  bool began_ = false;
  Cycle sampled_ = -1;  // the last one
};

}  // namespace cigsim
