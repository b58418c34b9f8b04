// SPDX-License-Identifier: MIT
// Video processor, clocked level (docs/machine/video_processor.md): the registers and pins of its
// two sides, one transition a clock.
#pragma once

#include <array>
#include <systemc>
#include <vector>

#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/machine/description.hpp"
#include "models/video_processor/bank.hpp"
#include "models/video_processor/face_memory.hpp"
#include "models/video_processor/figures.hpp"

namespace cigsim::video_processor {

class Clocked : public sc_core::sc_module {
 public:
  /// `time` numbers the cycles of `clock`; `banks` must outlive this.
  Clocked(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
          const VideoBanks& banks, Outputs outputs = {});

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<FaceWord> faces{"faces"};
  PinOut<FrameWord> loaded{"loaded"};
  PinIn<FrameWord> start{"start"};
  PinIn<SpanWord> spans{"spans"};
  PinOut<FrameWord> shown{"shown"};

  /// The video, in the cycle in which the elements leave: whether any do, and of the first of them
  /// the line, the element and the colour (as in Picture).
  sc_core::sc_signal<bool> video_on{"video_on"};
  sc_core::sc_signal<std::uint32_t> video_line{"video_line"}, video_element{"video_element"},
      video_colour{"video_colour"};

  void trace(sc_core::sc_trace_file* file) const;

 private:
  enum class State : std::uint8_t { kRest, kShowing, kShown };
  struct LineBuffer {
    std::vector<SpanWord> spans;
    bool complete = false;
  };

  void load_edge();
  void display_edge();
  void begin(std::uint32_t frame, Cycle now);
  void take_span();
  void show_elements(Cycle now);
  void pace_raster(Cycle now);
  void finish(Cycle now);
  void set_video();
  const Shade& shade() const;

  const Clock& time_;
  const VideoBanks& banks_;
  Outputs outputs_;
  Raster raster_;
  std::uint32_t width_, height_, elements_per_cycle_;
  Cycle blanking_, pitch_;  // VP5
  bool first_can_be_late_, others_can_be_late_;

  // Load side.
  std::array<FaceMemory, 2> faces_;
  std::uint32_t load_frame_ = 0;
  bool loaded_full_ = false;

  // Display side.
  State state_ = State::kRest;
  std::uint32_t frame_ = 0;
  Shade background_;
  std::array<LineBuffer, 2> buffers_;
  std::uint32_t fill_buffer_ = 0, filled_ = 0;  // the buffer that is filled; lines complete
  std::uint32_t show_buffer_ = 0, line_ = 0;    // the buffer that is shown; lines shown
  bool video_ = false;                          // elements leave in this cycle
  std::uint32_t element_ = 0;                   // the first of them
  std::size_t span_ = 0;                        // the span that it lies in
  Cycle timer_ = 0;                             // cycles until the raster lets a line begin
  Cycle lateness_ = 0;
  Cycle first_element_ = 0;
  Picture picture_;
  Figures figures_;
};

}  // namespace cigsim::video_processor
