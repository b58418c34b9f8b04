// SPDX-License-Identifier: MIT
// The machine's clock, for the stages at the clocked level and the transactors.
//
// Cycle n ends with the n-th rising edge (counted from 0), (n + 1) periods after the start. A
// process on that edge reads the pins of cycle n, and cycle() is n until the next edge.
#pragma once

#include <systemc>

#include "models/boundary/cycle.hpp"

namespace cigsim {

class Clock : public sc_core::sc_module {
 public:
  /// `period_ns`: length of a cycle in SystemC's time, so that waves show the machine's. It stands
  /// still until start().
  Clock(sc_core::sc_module_name name, double period_ns)
      : sc_module(name),
        period_(period_ns, sc_core::SC_NS),
        high_(period_ / 2),
        low_(period_ - high_) {
    SC_HAS_PROCESS(Clock);
    SC_METHOD(turn);
    dont_initialize();
    sensitive << turn_;
  }

  sc_core::sc_signal<bool> wire{"clock"};

  /// Runs from here on, at the latest from the first cycle on in which a pin can matter.
  void start() {
    if (running_) return;
    running_ = true;
    turn_.notify(wire.read() ? high_ : low_ + (cycle_ < 0 ? high_ : sc_core::SC_ZERO_TIME));
  }
  /// No further edges: the simulation starves, and sc_start returns.
  void stop() {
    running_ = false;
    turn_.cancel();
  }

  /// The cycle that the last rising edge ended; -1 before the first.
  Cycle cycle() const { return cycle_; }
  const sc_core::sc_time& period() const { return period_; }
  /// From the rising edge that ended cycle() to shortly before the one that ends cycle `n`, which
  /// must be later.
  sc_core::sc_time time_before(Cycle n) const {
    return static_cast<double>(n - cycle_ - 1) * period_ + high_;
  }

 private:
  void turn() {
    const bool rising = !wire.read();
    if (rising) ++cycle_;
    wire.write(rising);
    turn_.notify(rising ? high_ : low_);
  }

  sc_core::sc_time period_, high_, low_;
  sc_core::sc_event turn_;
  Cycle cycle_ = -1;
  bool running_ = false;
};

}  // namespace cigsim
