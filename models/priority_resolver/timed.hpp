// SPDX-License-Identifier: MIT
// Priority resolver, timed level (docs/machine/priority_resolver.md): a process that takes the
// crossings and gives the spans in exact cycles, without a clock.
#pragma once

#include <systemc>

#include "models/boundary/link.hpp"
#include "models/boundary/words.hpp"
#include "models/machine/description.hpp"
#include "models/priority_resolver/active_list.hpp"
#include "models/priority_resolver/figures.hpp"
#include "models/priority_resolver/span_check.hpp"

namespace cigsim::priority_resolver {

class Timed : public sc_core::sc_module {
 public:
  struct Links {
    Link<CrossingWord>& crossings;
    Link<SpanWord>& spans;
  };

  /// `figures`, which may be empty, is called once a frame, with frames counted from 0.
  Timed(sc_core::sc_module_name name, const MachineDescription& machine, Links links,
        FiguresFunction figures = {});

 private:
  void run();
  void frame();
  void line();
  void end_line(const CrossingWord& word, std::uint16_t at, Cycle now);
  void close(std::uint16_t end, std::uint32_t next, bool last, Cycle now);
  void put(const SpanWord& span, Cycle now);

  Link<CrossingWord>& in_;
  Link<SpanWord>& out_;
  FiguresFunction report_;
  std::uint16_t width_;
  int height_;

  ActiveList active_;
  std::uint16_t start_ = 0;
  std::uint32_t shown_ = kNone;
  Cycle free_ = 0;  // from this cycle on the output register is free (PR2)
  std::uint32_t line_spans_ = 0;
  Cycle moves_ = 0;  // cycles that only put a span into the register (PR6)
  SpanCheck check_;
  Figures figures_;
};

}  // namespace cigsim::priority_resolver
