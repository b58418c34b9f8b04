// SPDX-License-Identifier: MIT
#include "models/priority_resolver/clocked.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

#include "models/boundary/tracer.hpp"

namespace cigsim::priority_resolver {

Clocked::Clocked(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
                 FiguresFunction figures)
    : sc_module(name),
      time_(time),
      report_(std::move(figures)),
      width_(static_cast<std::uint16_t>(machine.raster.width)),
      height_(static_cast<std::uint32_t>(machine.raster.height)) {
  SC_HAS_PROCESS(Clocked);
  SC_METHOD(edge);
  dont_initialize();
  sensitive << clock.pos();
  SC_METHOD(set_ready);
  sensitive << spans.valid << spans.ready << closing_wait_;
}

// PR2 and PR3.
void Clocked::set_ready() {
  const bool free = !spans.valid.read() || spans.ready.read();
  crossings.ready.write(free && !closing_wait_.read());
}

void Clocked::edge() {
  if (!clock.posedge()) return;  // woken between two edges: the next one counts
  const Cycle now = time_.cycle();
  count_sleep(now);
  if (full_ && spans.ready.read()) {
    full_ = false;
    if (in_frame_ && line_ == height_ && closing_count_ == 0) finish(now);
  }
  if (closing_next_ < closing_count_) {
    if (!full_) {
      put(closing_[closing_next_++]);
      ++busy_;
    } else {
      ++figures_.activity.stalled;
    }
  } else if (crossings.valid.read() && crossings.ready.read()) {
    take(crossings.word.read(), now);
  } else if (full_) {
    ++figures_.activity.stalled;
  }
  if (closing_next_ == closing_count_) closing_next_ = closing_count_ = 0;

  closing_wait_.write(closing_count_ != 0);
  spans.valid.write(full_);
  if (full_) spans.word.write(register_);
  sleep(now);
}

// Nothing can happen before a word comes, or goes: PR2, PR3.
void Clocked::sleep(Cycle now) {
  last_edge_ = now;
  if (full_) {
    if (!spans.ready.read() && spans.valid.read()) next_trigger(spans.ready.posedge_event());
  } else if (!crossings.valid.read()) {
    next_trigger(crossings.valid.posedge_event());
  }
}

// The cycles slept through were stalled, or else idle.
void Clocked::count_sleep(Cycle now) {
  if (full_) figures_.activity.stalled += now - last_edge_ - 1;
}

void Clocked::finish(Cycle now) {
  Activity& activity = figures_.activity;
  activity.finish = now;
  activity.idle = now - activity.start - busy_ - activity.stalled;
  if (report_) report_(figures_);
  const std::uint32_t next = figures_.frame + 1;
  figures_ = {};
  figures_.frame = next;
  in_frame_ = false;
}

void Clocked::take(const CrossingWord& word, Cycle now) {
  if (!in_frame_) {
    in_frame_ = true;
    figures_.activity.start = now;
    busy_ = 0;
    line_ = line_spans_ = 0;
  }
  ++busy_;
  if (word.end)
    take_end(word);
  else
    take_crossing(word);
}

void Clocked::take_crossing(const CrossingWord& word) {
  assert(word.element >= at_ && word.element <= width_);
  if (word.element > at_) {  // PR4
    const std::uint32_t answer = encoder();
    if (answer != shown_) {
      if (start_ < at_) {
        put({shown_, start_, at_, false});
        ++line_spans_;
      }
      start_ = at_;
      shown_ = answer;
    }
    at_ = word.element;
  }
  apply(word.face, word.left);  // PR5
  ++figures_.crossings;
  figures_.most_active = std::max(figures_.most_active, active_count_);
}

// PR6 to PR8.
void Clocked::take_end(const CrossingWord& word) {
  const std::uint16_t limit = word.cut ? word.element : width_;
  assert(limit >= at_ && limit <= width_);
  const std::uint32_t answer = encoder();
  if (at_ < limit && answer != shown_) close(at_, answer);
  if (limit < width_ && shown_ != kNone) close(limit, kNone);
  close(width_, kNone);
  closing_[closing_count_ - 1].last = true;
  put(closing_[0]);
  closing_next_ = 1;

  at_ = start_ = 0;
  active_count_ = 0;
  std::fill(faces_.active.begin(), faces_.active.end(), 0);
  std::fill(faces_.passed.begin(), faces_.passed.end(), 0);

  line_spans_ += closing_count_;
  figures_.spans += line_spans_;
  if (line_spans_ > figures_.worst_line_spans) {
    figures_.worst_line_spans = line_spans_;
    figures_.worst_line = line_;
  }
  line_spans_ = 0;
  ++line_;
}

void Clocked::close(std::uint16_t end, std::uint32_t next) {
  if (start_ < end) closing_[closing_count_++] = {shown_, start_, end, false};
  start_ = end;
  shown_ = next;
}

void Clocked::put(const SpanWord& span) {
  check_.span(span, width_);
  register_ = span;
  full_ = true;
  figures_.face_spans += span.face != kNone;
}

// PR1. Two bits a face: both clear is 0, and both are never set.
void Clocked::apply(std::uint32_t face, bool left) {
  const std::size_t w = face / 64;
  const std::uint64_t bit = std::uint64_t{1} << (face % 64);
  if (w >= faces_.active.size()) {
    faces_.active.resize(w + 1, 0);
    faces_.passed.resize(w + 1, 0);
  }
  std::uint64_t& gains = left ? faces_.active[w] : faces_.passed[w];
  std::uint64_t& loses = left ? faces_.passed[w] : faces_.active[w];
  if (loses & bit) {
    loses &= ~bit;
    active_count_ -= !left;
  } else if (!(gains & bit)) {
    gains |= bit;
    active_count_ += left;
  }
  assert(left || !(faces_.active[w] & bit));
}

std::uint32_t Clocked::encoder() const {
  for (std::size_t w = 0; w < faces_.active.size(); ++w)
    if (faces_.active[w] != 0)
      return static_cast<std::uint32_t>(
          w * 64 + static_cast<std::size_t>(std::countr_zero(faces_.active[w])));
  return kNone;
}

void Clocked::trace(sc_core::sc_trace_file* file) const {
  const Tracer show(file, *this);
  show.pins(crossings, "crossings");
  show.pins(spans, "spans");
  show.pin(closing_wait_, "closing_wait");
  show.state(at_, "at");
  show.state(start_, "start");
  show.state(shown_, "shown");
  show.state(line_, "line");
  show.state(active_count_, "active_count");
}

}  // namespace cigsim::priority_resolver
