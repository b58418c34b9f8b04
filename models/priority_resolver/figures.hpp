// SPDX-License-Identifier: MIT
// What the priority resolver tells about a frame at the timed and clocked levels.
#pragma once

#include <cstdint>
#include <functional>

#include "models/boundary/activity.hpp"

namespace cigsim::priority_resolver {

struct Figures : StageFigures {
  std::uint64_t crossings = 0;
  std::uint64_t spans = 0;       ///< of the background too
  std::uint64_t face_spans = 0;  ///< that show a face
  std::uint32_t worst_line = 0;  ///< the first of the lines with the most spans
  std::uint32_t worst_line_spans = 0;
  std::uint32_t most_active = 0;  ///< faces that were active at once
  friend bool operator==(const Figures&, const Figures&) = default;
};

using FiguresFunction = std::function<void(const Figures&)>;

}  // namespace cigsim::priority_resolver
