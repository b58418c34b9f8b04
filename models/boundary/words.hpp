// SPDX-License-Identifier: MIT
// The transactions of the timed and clocked levels, one link each, in machine words. Every stream
// of a frame ends with a word whose `end` is set and whose other fields are zero unless stated.
#pragma once

#include <cstdint>

#include "models/boundary/transactions.hpp"
#include "models/numeric/machine_word.hpp"

namespace cigsim {

/// Frame start to a stage (sync -> stage) and completion (stage -> sync).
struct FrameWord {
  std::uint32_t frame = 0;
  friend bool operator==(const FrameWord&, const FrameWord&) = default;
};

/// frame_calculator -> priority_processor and geometry_processor: the eyepoint in scaled
/// coordinates and the view matrix in 1.30, rows as in docs/machine.md, "View matrix".
struct ViewWords {
  Word eye[3] = {};
  Word matrix[3][3] = {};
  Raster raster;
};

/// priority_processor -> geometry_processor: the items of a frame, highest priority first.
struct ItemWord {
  SetId set = SetId::kStatic;
  std::uint32_t item = 0;
  bool end = false;
  friend bool operator==(const ItemWord&, const ItemWord&) = default;
};

/// geometry_processor -> edge_orderer. Faces are numbered from 0 in the order of their priority, so
/// that a face's number is its priority. On line r in [first_line, end_line) the edge crosses
/// column x + slope (r - first_line), measured as in Edge.
struct EdgeWord {
  std::uint32_t face = 0;
  std::uint16_t first_line = 0, end_line = 0;  ///< 0..height, first_line < end_line
  bool left = false;
  bool end = false;
  Word x = 0, slope = 0;  ///< 13.18
  friend bool operator==(const EdgeWord&, const EdgeWord&) = default;
};

/// geometry_processor -> video_processor: what a face looks like.
struct FaceWord {
  std::uint32_t face = 0;
  bool end = false;
  std::uint32_t object = 0;
  std::uint32_t colour = 0;  ///< 0x00BBGGRR
  friend bool operator==(const FaceWord&, const FaceWord&) = default;
};

/// edge_orderer -> priority_resolver: the crossings of a line in the order of OrderedCrossings,
/// then the line's end. In the end word `cut` says that crossings at and after `element` were cut
/// from the line (policy kCut).
struct CrossingWord {
  std::uint32_t face = 0;
  std::uint16_t element = 0;  ///< 0..width
  bool left = false;
  bool end = false;  ///< of the line
  bool cut = false;
  friend bool operator==(const CrossingWord&, const CrossingWord&) = default;
};

/// priority_resolver -> video_processor: elements [first, end) show a face. The spans of a
/// line cover it once, from left to right.
struct SpanWord {
  std::uint32_t face = kNone;  ///< kNone: background
  std::uint16_t first = 0, end = 0;
  bool last = false;  ///< of the line
  friend bool operator==(const SpanWord&, const SpanWord&) = default;
};

}  // namespace cigsim
