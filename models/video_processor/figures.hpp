// SPDX-License-Identifier: MIT
// What the video processor gives at the timed and clocked levels: the picture and its figures.
#pragma once

#include <cstdint>
#include <functional>

#include "models/boundary/activity.hpp"
#include "models/boundary/transactions.hpp"

namespace cigsim::video_processor {

struct Figures : StageFigures {
  std::uint64_t spans = 0;       ///< of the background too
  std::uint32_t late_lines = 0;  ///< shown later than the raster asks for
  Cycle worst_lateness = 0;      ///< cycles
  friend bool operator==(const Figures&, const Figures&) = default;
};

/// Where the video processor's results go. Each may be empty.
struct Outputs {
  /// The figures of a frame, when its frame word went into the link `shown`.
  std::function<void(const Figures&)> figures;
  /// A picture, with the cycles in which its first and its last elements left.
  std::function<void(std::uint32_t frame, const Picture&, Cycle first, Cycle last)> picture;
  /// A line, with the cycle S(line) in which its first elements left.
  std::function<void(std::uint32_t frame, std::uint32_t line, Cycle shown)> line;
};

}  // namespace cigsim::video_processor
