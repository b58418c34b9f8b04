// SPDX-License-Identifier: MIT
// Which faces pierce an element, by the machine's rule: a face is there from the first element at
// or right of its left edge up to the first one at or right of its right edge. What the page of a
// report works out where it is clicked, page/priority.js does the same way.
#pragma once

#include "models/machine/description.hpp"
#include "sim/frame_faces.hpp"

namespace cigsim {

/// What a machine drops from one line (docs/machine/edge_orderer.md, EO4).
struct LineLimit {
  std::uint32_t faces = kNone;     ///< faces from this one on are not there
  std::uint32_t elements = kNone;  ///< elements from this one on show the background
};

/// Faces beyond the first `count` are taken away: those that the machine had no time for.
void keep_first(FrameFaces& faces, std::size_t count);

/// Crossings of each line, before any are dropped.
std::vector<std::uint32_t> crossings_by_line(const FrameFaces& faces, int height);

/// For each line; `capacity` crossings fit, 0: all.
std::vector<LineLimit> line_limits(const FrameFaces& faces, int height, std::uint32_t capacity,
                                   OverloadPolicy policy);

/// The picture that these faces make.
Picture shown_picture(const FrameFaces& faces, const std::vector<LineLimit>& limits,
                      const Colour& background, const Raster& raster);

}  // namespace cigsim
