// SPDX-License-Identifier: MIT
#include "models/video_processor/timed.hpp"

#include <algorithm>

#include "models/numeric/dispatch.hpp"

namespace cigsim::video_processor {
namespace {

CIGSIM_DISPATCH
void fill_spans(const SpanWord* spans, std::size_t count, const FaceMemory& faces,
                const Shade& background, std::uint32_t* colours, std::uint16_t* numbers) {
  for (std::size_t s = 0; s < count; ++s) {
    const SpanWord& span = spans[s];
    const Shade& shade = span.face == kNone ? background : faces[span.face];
    fill_run(colours + span.first, numbers + span.first, span.end - span.first, shade.colour,
             shade.number);
  }
}

}  // namespace

Timed::Timed(sc_core::sc_module_name name, const MachineDescription& machine, Links links,
             const VideoBanks& banks, Outputs outputs)
    : sc_module(name),
      links_(links),
      banks_(banks),
      outputs_(std::move(outputs)),
      raster_(machine.raster),
      blanking_(std::max<Cycle>(machine.vertical_blanking(), 1)),
      line_length_((raster_.width + machine.elements_per_cycle - 1) / machine.elements_per_cycle),
      first_can_be_late_(machine.line_cycles > 0 && machine.frame_cycles > 0),
      others_can_be_late_(machine.line_cycles > 0) {
  pitch_ = std::max(machine.line_cycles, line_length_);
  SC_HAS_PROCESS(Timed);
  SC_THREAD(load);
  SC_THREAD(display);
}

void Timed::load() {
  Cycle free = 0;  // the first cycle that begins with the `loaded` register empty
  for (std::uint32_t k = 0;; ++k) {
    for (;;) {
      const Cycle now = std::max(links_.faces.available(), free);  // VP1
      const FaceWord word = links_.faces.front();
      links_.faces.take(now);
      if (word.end) {
        free = links_.loaded.push_from({k}, now + 1) + 1;  // VP2
        break;
      }
      faces_[k % 2].store(word);
    }
  }
}

void Timed::display() {
  Cycle rest = 0;  // the first cycle that begins at rest (VP3)
  for (;;) {
    const Cycle begin = std::max(links_.start.available(), rest);
    const std::uint32_t frame = links_.start.front().frame;
    links_.start.take(begin);
    figures_ = {};
    figures_.frame = frame;
    figures_.activity.start = begin;
    show_picture(frame);
    rest = figures_.activity.finish + 1;
    if (outputs_.figures) outputs_.figures(figures_);
  }
}

void Timed::show_picture(std::uint32_t frame) {
  picture_.fit(raster_);
  const Shade background{packed(banks_[frame % 2].background), 0};
  Cycle raster = figures_.activity.start + blanking_;  // R(r)
  Cycle ends[2] = {0, 0};                              // E(r), by the parity of the line
  Cycle next = figures_.activity.start + 1;            // the next span can be taken
  Cycle first = 0;                                     // S(0)
  for (int r = 0; r < raster_.height; ++r) {
    Cycle& end = ends[r % 2];
    const Cycle complete = take_line(std::max(next, end + 1));
    next = complete + 1;
    const Cycle shown = std::max(raster, complete + 1);  // VP6
    const Cycle lateness = shown - raster;
    figures_.activity.idle += lateness;
    if (lateness > 0 && (r == 0 ? first_can_be_late_ : others_can_be_late_)) {
      ++figures_.late_lines;
      figures_.worst_lateness = std::max(figures_.worst_lateness, lateness);
    }
    if (r == 0) first = shown;
    if (outputs_.line) outputs_.line(frame, static_cast<std::uint32_t>(r), shown);
    fill_line(r, faces_[frame % 2], background);
    end = shown + line_length_ - 1;
    raster = shown + pitch_;
  }
  const Cycle last = ends[(raster_.height - 1) % 2];
  if (outputs_.picture) outputs_.picture(frame, picture_, first, last);
  figures_.activity.finish = links_.shown.push_from({frame}, last + 1);  // VP8
  figures_.activity.stalled = figures_.activity.finish - last - 1;
}

// The spans of a line, the first in cycle `free` or later; gives C(r).
Cycle Timed::take_line(Cycle free) {
  line_.clear();
  for (;;) {
    const Cycle now = std::max(links_.spans.available(), free);  // VP4
    line_.push_back(links_.spans.front());
    links_.spans.take(now);
    if (!line_.back().last) continue;
    figures_.spans += line_.size();
    return now;
  }
}

void Timed::fill_line(int line, const FaceMemory& faces, const Shade& background) {
  const std::size_t row = static_cast<std::size_t>(line) * static_cast<std::size_t>(raster_.width);
  fill_spans(line_.data(), line_.size(), faces, background, picture_.colours.data() + row,
             picture_.numbers.data() + row);
}

}  // namespace cigsim::video_processor
