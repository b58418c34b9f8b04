// SPDX-License-Identifier: MIT
#include "models/priority_resolver/timed.hpp"

#include <algorithm>
#include <cassert>

namespace cigsim::priority_resolver {

Timed::Timed(sc_core::sc_module_name name, const MachineDescription& machine, Links links,
             FiguresFunction figures)
    : sc_module(name),
      in_(links.crossings),
      out_(links.spans),
      report_(std::move(figures)),
      width_(static_cast<std::uint16_t>(machine.raster.width)),
      height_(machine.raster.height) {
  SC_HAS_PROCESS(Timed);
  SC_THREAD(run);
  active_.grow(machine.face_capacity);
}

void Timed::run() {
  for (std::uint32_t k = 0;; ++k) {
    figures_ = {};
    figures_.frame = k;
    frame();
    if (report_) report_(figures_);
  }
}

void Timed::frame() {
  Activity& activity = figures_.activity;
  activity.start = std::max(in_.available(), free_);
  moves_ = 0;
  for (int r = 0; r < height_; ++r) {
    line_spans_ = 0;
    line();
    figures_.spans += line_spans_;
    if (line_spans_ <= figures_.worst_line_spans) continue;
    figures_.worst_line_spans = line_spans_;
    figures_.worst_line = static_cast<std::uint32_t>(r);
  }
  activity.finish = free_;
  const Cycle words = static_cast<Cycle>(figures_.crossings) + height_;
  const Cycle busy = words + moves_ + 1;
  activity.idle = activity.finish - activity.start + 1 - busy - activity.stalled;
}

void Timed::line() {
  std::uint16_t at = 0;
  std::uint64_t passed = 0;
  int most_active = 0;
  CrossingWord word;
  for (;; ++passed) {
    const Cycle now = std::max(in_.available(), free_);  // PR3
    word = in_.front();
    in_.take(now);
    if (word.end) {
      end_line(word, at, now);
      break;
    }
    assert(word.element >= at && word.element <= width_);
    if (word.element > at) {  // PR4
      const std::uint32_t answer = active_.first();
      if (answer != shown_) close(at, answer, false, now);
      at = word.element;
    }
    if (word.face >= active_.size()) active_.grow(2 * std::size_t{word.face} + 64);
    active_.pass(word.face, word.left);  // PR5
    most_active = std::max(most_active, active_.count());
  }
  figures_.crossings += passed;
  figures_.most_active = std::max(figures_.most_active, static_cast<std::uint32_t>(most_active));
}

// PR6. A further span goes into the register in the first cycle in which it is free again.
void Timed::end_line(const CrossingWord& word, std::uint16_t at, Cycle now) {
  const std::uint16_t limit = word.cut ? word.element : width_;
  assert(limit >= at && limit <= width_);
  const std::uint32_t spans_before = line_spans_;
  const auto next = [&] { return std::max(now, free_); };
  const std::uint32_t answer = at < limit ? active_.first() : shown_;
  if (answer != shown_) close(at, answer, false, now);
  if (limit < width_ && shown_ != kNone) close(limit, kNone, false, next());
  close(width_, kNone, true, next());
  moves_ += line_spans_ - spans_before - 1;
  start_ = 0;  // PR8
  active_.clear();
}

void Timed::close(std::uint16_t end, std::uint32_t next, bool last, Cycle now) {
  if (start_ < end) put({shown_, start_, end, last}, now);
  start_ = end;
  shown_ = next;
}

void Timed::put(const SpanWord& span, Cycle now) {
  check_.span(span, width_);
  free_ = out_.push_from(span, now + 1);
  figures_.activity.stalled += free_ - now - 1;
  ++line_spans_;
  figures_.face_spans += span.face != kNone;
}

}  // namespace cigsim::priority_resolver
