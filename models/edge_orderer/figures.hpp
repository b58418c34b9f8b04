// SPDX-License-Identifier: MIT
// What the edge orderer tells about a frame on machine words.
#pragma once

#include <cstdint>
#include <functional>

#include "models/boundary/activity.hpp"

namespace cigsim::edge_orderer {

/// `dropped` of StageFigures are crossings dropped or cut from lines.
struct Figures : StageFigures {
  std::uint64_t edges = 0;
  std::uint64_t crossings = 0;   ///< before anything was dropped
  std::uint32_t worst_line = 0;  ///< the first of the lines with the most crossings
  std::uint32_t worst_line_crossings = 0;
  std::uint32_t overfull_lines = 0;
  std::uint64_t passes = 0;  ///< through the edges of a line, over all lines
  friend bool operator==(const Figures&, const Figures&) = default;
};

using FiguresFunction = std::function<void(const Figures&)>;

}  // namespace cigsim::edge_orderer
