// SPDX-License-Identifier: MIT
// Video processor, timed level (docs/machine/video_processor.md): two processes, the load side and
// the display side, that find the exact cycles without a clock.
#pragma once

#include <array>
#include <systemc>
#include <vector>

#include "models/boundary/link.hpp"
#include "models/boundary/words.hpp"
#include "models/machine/description.hpp"
#include "models/video_processor/bank.hpp"
#include "models/video_processor/face_memory.hpp"
#include "models/video_processor/figures.hpp"

namespace cigsim::video_processor {

class Timed : public sc_core::sc_module {
 public:
  struct Links {
    Link<FaceWord>& faces;
    Link<FrameWord>& loaded;
    Link<FrameWord>& start;
    Link<SpanWord>& spans;
    Link<FrameWord>& shown;
  };

  /// `banks` must outlive this; a bank is read when its picture starts.
  Timed(sc_core::sc_module_name name, const MachineDescription& machine, Links links,
        const VideoBanks& banks, Outputs outputs = {});

 private:
  void load();
  void display();
  void show_picture(std::uint32_t frame);
  Cycle take_line(Cycle free);
  void fill_line(int line, const FaceMemory& faces, const Shade& background);

  Links links_;
  const VideoBanks& banks_;
  Outputs outputs_;
  Raster raster_;
  Cycle blanking_, pitch_, line_length_;  // VP5; cycles in which elements of a line leave
  bool first_can_be_late_, others_can_be_late_;

  std::array<FaceMemory, 2> faces_;
  std::vector<SpanWord> line_;
  Picture picture_;
  Figures figures_;
};

}  // namespace cigsim::video_processor
