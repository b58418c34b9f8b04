// SPDX-License-Identifier: MIT
// Priority resolver, clocked level (docs/machine/priority_resolver.md): the registers and pins,
// one transition a clock.
#pragma once

#include <array>
#include <systemc>
#include <vector>

#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/machine/description.hpp"
#include "models/priority_resolver/figures.hpp"
#include "models/priority_resolver/span_check.hpp"

namespace cigsim::priority_resolver {

class Clocked : public sc_core::sc_module {
 public:
  /// `time` numbers the cycles of `clock`. `figures`, which may be empty, is called once a frame,
  /// with frames counted from 0.
  Clocked(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
          FiguresFunction figures = {});

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<CrossingWord> crossings{"crossings"};
  PinOut<SpanWord> spans{"spans"};

  void trace(sc_core::sc_trace_file* file) const;

 private:
  // The inside states, a bit a face: +1, of which the encoder tells the first, and -1.
  struct FacePlanes {
    std::vector<std::uint64_t> active, passed;
  };

  void edge();
  void set_ready();
  void count_sleep(Cycle now);
  void finish(Cycle now);
  void take(const CrossingWord& word, Cycle now);
  void take_crossing(const CrossingWord& word);
  void take_end(const CrossingWord& word);
  void close(std::uint16_t end, std::uint32_t next);
  void put(const SpanWord& span);
  void apply(std::uint32_t face, bool left);
  std::uint32_t encoder() const;
  void sleep(Cycle now);

  const Clock& time_;
  FiguresFunction report_;
  std::uint16_t width_;
  std::uint32_t height_;

  FacePlanes faces_;
  std::uint16_t at_ = 0, start_ = 0;
  std::uint32_t shown_ = kNone;
  SpanWord register_;
  bool full_ = false;
  std::array<SpanWord, 3> closing_;  // spans of the line's end, in their order
  std::uint32_t closing_count_ = 0, closing_next_ = 0;
  sc_core::sc_signal<bool> closing_wait_{"closing_wait"};  // a span waits to be closed (PR6)

  bool in_frame_ = false;
  std::uint32_t line_ = 0, line_spans_ = 0, active_count_ = 0;
  Cycle busy_ = 0;
  Cycle last_edge_ = -1;
  SpanCheck check_;
  Figures figures_;
};

}  // namespace cigsim::priority_resolver
