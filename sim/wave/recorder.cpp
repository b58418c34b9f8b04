// SPDX-License-Identifier: MIT
#include "sim/wave/recorder.hpp"

#include <algorithm>

namespace cigsim {

Recorder::Recorder(sc_core::sc_module_name name, const Clock& clock, const std::string& clock_name,
                   std::ostream& out, const CycleWindow& window,
                   std::function<void(sc_core::sc_trace_file*)> trace)
    : sc_module(name),
      clock_(clock),
      writer_(out, clock.period().to_seconds() * 1e9, clock_name),
      window_(window),
      trace_(std::move(trace)) {
  SC_HAS_PROCESS(Recorder);
  SC_METHOD(look);
  sensitive << clock_.wire.negedge_event();
}

void Recorder::start_of_simulation() {
  trace_(&writer_);
  writer_.declare();
}

// Cycle n ends with the n-th rising edge, so that the falling edge after it is in cycle n + 1. In
// cycle 0 there is none.
void Recorder::look() {
  if (!began_) {
    began_ = true;
    return next_trigger(clock_.period() / 2);
  }
  const Cycle now = clock_.cycle() + 1;
  if (now < window_.first) {
    const Cycle skipped = window_.first - now - 1;
    if (skipped > 0) next_trigger(static_cast<double>(skipped) * clock_.period());
    return;
  }
  if (now > window_.last) return next_trigger(never_);
  writer_.sample(now);
  sampled_ = now;
}

void Recorder::finish() { writer_.end(std::max(sampled_ + 1, window_.first)); }

}  // namespace cigsim
