// SPDX-License-Identifier: MIT
#include "models/priority_resolver/rtl.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "models/boundary/tracer.hpp"
#include "models/boundary/wave_part.hpp"
#include "rtl/priority_resolver/priority_resolver.pins.hpp"

namespace cigsim::priority_resolver {

using rtl::priority_resolver::Pins;

Rtl::Rtl(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
         const std::filesystem::path& library, FiguresFunction figures, std::uint32_t seed)
    : sc_module(name),
      time_(time),
      report_(std::move(figures)),
      height_(static_cast<std::uint32_t>(machine.raster.height)),
      model_(library, sizeof(Pins), seed) {
  SC_HAS_PROCESS(Rtl);
  SC_METHOD(edge);
  dont_initialize();
  sensitive << clock.pos();
  SC_METHOD(set_ready);
  sensitive << spans.ready << outputs_;

  Pins& pins = model_.pins<Pins>();
  pins.cfg_width_i = static_cast<std::uint16_t>(machine.raster.width);
  pins.rst_i = true;
  model_.edge();
  model_.edge();
  pins.rst_i = false;
}

// PR2 and PR3: what is ready depends, within a cycle, on whether the link is.
void Rtl::set_ready() {
  Pins& pins = model_.pins<Pins>();
  pins.spans_ready_i = spans.ready.read();
  model_.settle();
  crossings.ready.write(pins.crossings_ready_o);
}

void Rtl::drive() {
  Pins& pins = model_.pins<Pins>();
  const CrossingWord& word = crossings.word.read();
  pins.crossings_valid_i = crossings.valid.read();
  pins.crossings_face_i = word.face;
  pins.crossings_element_i = word.element;
  pins.crossings_left_i = word.left;
  pins.crossings_end_i = word.end;
  pins.crossings_cut_i = word.cut;
  pins.spans_ready_i = spans.ready.read();
}

void Rtl::edge() {
  count(time_.cycle());
  const Pins& pins = model_.pins<Pins>();
  const CrossingWord& word = crossings.word.read();
  const bool taken = crossings.valid.read() && crossings.ready.read();
  drive();
  model_.edge();

  if (pins.mon_too_small_o)
    throw std::runtime_error("priority_resolver: face " + std::to_string(word.face) +
                             ": the picture has more faces than this RTL size holds");
  if (taken && word.end) active_count_ = 0;
  active_count_ += pins.mon_entered_o;
  active_count_ -= pins.mon_taken_out_o;
  figures_.most_active = std::max(figures_.most_active, active_count_);

  spans.valid.write(pins.spans_valid_o);
  if (pins.spans_valid_o)
    spans.word.write({pins.spans_background_o ? kNone : pins.spans_face_o, pins.spans_first_o,
                      pins.spans_end_o, pins.spans_last_o});
  if (pins.crossings_ready_o != crossings.ready.read()) outputs_.notify(sc_core::SC_ZERO_TIME);
}

// What the pins of cycle `now` tell; "Activity" of docs/machine/priority_resolver.md.
void Rtl::count(Cycle now) {
  const bool valid = spans.valid.read(), free = !valid || spans.ready.read();
  if (valid && free) count_span(now);
  if (crossings.valid.read() && crossings.ready.read()) {
    if (!in_frame_) {
      in_frame_ = true;
      figures_.activity.start = now;
      busy_ = 0;
      line_ = line_spans_ = 0;
    }
    ++busy_;
    figures_.crossings += !crossings.word.read().end;
  } else if (!free) {
    ++figures_.activity.stalled;
  } else if (!crossings.ready.read()) {
    ++busy_;  // a span of the line's end goes into the register (PR6)
  }
}

void Rtl::count_span(Cycle now) {
  const SpanWord& span = spans.word.read();
  ++figures_.spans;
  figures_.face_spans += span.face != kNone;
  ++line_spans_;
  if (!span.last) return;
  if (line_spans_ > figures_.worst_line_spans) {
    figures_.worst_line_spans = line_spans_;
    figures_.worst_line = line_;
  }
  line_spans_ = 0;
  if (++line_ == height_) finish(now);
}

void Rtl::finish(Cycle now) {
  Activity& activity = figures_.activity;
  activity.finish = now;
  activity.idle = now - activity.start - busy_ - activity.stalled;
  if (report_) report_(figures_);
  const std::uint32_t next = figures_.frame + 1;
  figures_ = {};
  figures_.frame = next;
  in_frame_ = false;
}

void Rtl::trace(sc_core::sc_trace_file* file) {
  const Tracer show(file, *this);
  show.pins(crossings, "crossings");
  show.pins(spans, "spans");
  trace_rtl(file, *this, model_, [this] { drive(); });
}

}  // namespace cigsim::priority_resolver
