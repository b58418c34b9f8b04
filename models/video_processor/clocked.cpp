// SPDX-License-Identifier: MIT
#include "models/video_processor/clocked.hpp"

#include <algorithm>

#include "models/boundary/tracer.hpp"

namespace cigsim::video_processor {

Clocked::Clocked(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
                 const VideoBanks& banks, Outputs outputs)
    : sc_module(name),
      time_(time),
      banks_(banks),
      outputs_(std::move(outputs)),
      raster_(machine.raster),
      width_(static_cast<std::uint32_t>(machine.raster.width)),
      height_(static_cast<std::uint32_t>(machine.raster.height)),
      elements_per_cycle_(machine.elements_per_cycle),
      blanking_(std::max<Cycle>(machine.vertical_blanking(), 1)),
      pitch_(std::max<Cycle>(machine.line_cycles,
                             (width_ + elements_per_cycle_ - 1) / elements_per_cycle_)),
      first_can_be_late_(machine.line_cycles > 0 && machine.frame_cycles > 0),
      others_can_be_late_(machine.line_cycles > 0) {
  faces.ready.initialize(true);
  start.ready.initialize(true);
  SC_HAS_PROCESS(Clocked);
  SC_METHOD(load_edge);
  dont_initialize();
  sensitive << clock.pos();
  SC_METHOD(display_edge);
  dont_initialize();
  sensitive << clock.pos();
}

// VP1 and VP2.
void Clocked::load_edge() {
  if (!clock.posedge()) return;  // woken between two edges: the next one counts
  if (loaded_full_) {
    if (!loaded.ready.read()) return;
    loaded_full_ = false;
  } else if (faces.valid.read()) {
    const FaceWord& word = faces.word.read();
    if (word.end) {
      loaded_full_ = true;
      loaded.word.write({load_frame_++});
    } else {
      faces_[load_frame_ % 2].store(word);
    }
  } else {
    next_trigger(faces.valid.posedge_event());
  }
  loaded.valid.write(loaded_full_);
  faces.ready.write(!loaded_full_);
}

void Clocked::display_edge() {
  if (!clock.posedge()) return;
  const Cycle now = time_.cycle();
  switch (state_) {
    case State::kRest:
      if (!start.valid.read()) return next_trigger(start.valid.posedge_event());
      begin(start.word.read().frame, now);
      break;
    case State::kShowing:
      if (timer_ > 0) --timer_;
      if (spans.valid.read() && spans.ready.read()) take_span();
      if (video_) show_elements(now);
      break;
    case State::kShown:
      if (shown.ready.read())
        finish(now);
      else
        ++figures_.activity.stalled;
      break;
  }
  if (state_ == State::kShowing) pace_raster(now);
  start.ready.write(state_ == State::kRest);
  spans.ready.write(state_ == State::kShowing && filled_ < height_ &&
                    !buffers_[fill_buffer_].complete);
  shown.valid.write(state_ == State::kShown);
  set_video();
}

// VP3, and VP5 for line 0.
void Clocked::begin(std::uint32_t frame, Cycle now) {
  state_ = State::kShowing;
  frame_ = frame;
  figures_ = {};
  figures_.frame = frame;
  figures_.activity.start = now;
  const Colour& background = banks_[frame % 2].background;
  background_.colour = 0xff000000u | std::uint32_t{background.b} << 16 |
                       std::uint32_t{background.g} << 8 | background.r;
  picture_.fit(raster_);
  filled_ = line_ = 0;
  lateness_ = 0;
  timer_ = blanking_ - 1;
}

// VP4.
void Clocked::take_span() {
  LineBuffer& buffer = buffers_[fill_buffer_];
  buffer.spans.push_back(spans.word.read());
  ++figures_.spans;
  if (!buffer.spans.back().last) return;
  buffer.complete = true;
  fill_buffer_ ^= 1;
  ++filled_;
}

// VP6 to VP8: the elements of this cycle leave.
void Clocked::show_elements(Cycle now) {
  const std::vector<SpanWord>& line = buffers_[show_buffer_].spans;
  const std::size_t row = std::size_t{line_} * width_;
  const std::uint32_t end = std::min(element_ + elements_per_cycle_, width_);
  while (element_ < end) {
    const Shade shown_shade = shade();
    const std::uint32_t run = std::min<std::uint32_t>(end, line[span_].end);
    for (; element_ < run; ++element_) {
      picture_.colours[row + element_] = shown_shade.colour;
      picture_.numbers[row + element_] = shown_shade.number;
    }
    if (element_ == line[span_].end) ++span_;
  }
  if (element_ < width_) return;
  video_ = false;
  buffers_[show_buffer_].spans.clear();
  buffers_[show_buffer_].complete = false;
  show_buffer_ ^= 1;
  if (++line_ < height_) return;
  state_ = State::kShown;
  shown.word.write({frame_});
  if (outputs_.picture) outputs_.picture(frame_, picture_, first_element_, now);
}

// VP5, VP6 and VP9: whether a line begins in the next cycle.
void Clocked::pace_raster(Cycle now) {
  if (video_ || timer_ > 0) return;
  if (!buffers_[show_buffer_].complete) {
    ++lateness_;
    return;
  }
  figures_.activity.idle += lateness_;
  if (lateness_ > 0 && (line_ == 0 ? first_can_be_late_ : others_can_be_late_)) {
    ++figures_.late_lines;
    figures_.worst_lateness = std::max(figures_.worst_lateness, lateness_);
  }
  lateness_ = 0;
  timer_ = pitch_;
  video_ = true;
  element_ = 0;
  span_ = 0;
  if (line_ == 0) first_element_ = now + 1;
  if (outputs_.line) outputs_.line(frame_, line_, now + 1);
}

void Clocked::finish(Cycle now) {
  state_ = State::kRest;
  figures_.activity.finish = now;
  if (outputs_.figures) outputs_.figures(figures_);
}

const Shade& Clocked::shade() const {
  const std::uint32_t face = buffers_[show_buffer_].spans[span_].face;
  return face == kNone ? background_ : faces_[frame_ % 2][face];
}

void Clocked::set_video() {
  video_on.write(video_);
  if (!video_) return;
  video_line.write(line_);
  video_element.write(element_);
  video_colour.write(shade().colour);
}

void Clocked::trace(sc_core::sc_trace_file* file) const {
  const Tracer show(file, *this);
  show.pins(faces, "faces");
  show.pins(loaded, "loaded");
  show.pins(start, "start");
  show.pins(spans, "spans");
  show.pins(shown, "shown");
  show.pin(video_on, "video_on");
  show.pin(video_line, "video_line");
  show.pin(video_element, "video_element");
  show.pin(video_colour, "video_colour");
  show.state(frame_, "frame");
  show.state(filled_, "lines_filled");
  show.state(line_, "line");
  show.state(buffers_[0].complete, "buffer0_complete");
  show.state(buffers_[1].complete, "buffer1_complete");
}

}  // namespace cigsim::video_processor
