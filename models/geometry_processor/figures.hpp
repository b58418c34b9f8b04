// SPDX-License-Identifier: MIT
// What the geometry processor tells about a frame, in machine words at every level.
#pragma once

#include <cstdint>
#include <functional>

#include "models/boundary/activity.hpp"

namespace cigsim::geometry_processor {

/// `overflows`: u, v and w that were saturated. `dropped`: faces that found no room or no time, and
/// all faces after them.
struct Figures : StageFigures {
  std::uint64_t faces = 0;          ///< looked at
  std::uint64_t front_faces = 0;    ///< put out: seen from their front, with an edge at least
  std::uint64_t edges = 0;          ///< put out
  std::uint64_t clipped_faces = 0;  ///< clipped, whether anything was left or not
  friend bool operator==(const Figures&, const Figures&) = default;
};

using FiguresFunction = std::function<void(const Figures&)>;

}  // namespace cigsim::geometry_processor
