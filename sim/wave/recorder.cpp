// SPDX-License-Identifier: MIT
#include "sim/wave/recorder.hpp"

#include <algorithm>

namespace cigsim {
namespace {

constexpr Cycle kLongestSleep = 1 << 20;  // cycles, which SystemC's time holds at any clock

}  // namespace

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
    // Woken from sleep it waits for the next falling edge; there is none if the run is over.
    if (!clock_.wire.negedge()) return;
    const Cycle skipped = std::min(window_.first - now - 1, kLongestSleep);
    if (skipped > 0) next_trigger(static_cast<double>(skipped) * clock_.period());
    return;
  }
  if (now > window_.last) return next_trigger(never_);
  writer_.sample(now);
  sampled_ = now;
}

void Recorder::finish() { writer_.end(std::max(sampled_ + 1, window_.first)); }

}  // namespace cigsim
