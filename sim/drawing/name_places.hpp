// SPDX-License-Identifier: MIT
// Where the names of points go on a plot, so that none covers another.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "models/numeric/orientation2.hpp"

namespace cigsim {

/// Pixels; y grows downwards.
struct PixelBox {
  double left = 0, top = 0, right = 0, bottom = 0;
};

struct NamedMark {
  Vec2 at;
  double width = 0, height = 0;  ///< of the name
  bool beside = false;           ///< lies best to the right or the left, not higher
};

struct NamePlace {
  PixelBox box;
  std::optional<Vec2> leader;  ///< where a line from the mark ends, when the name is not beside it
};

/// One place a named mark, inside `frame`, beside or as near as there is room, and preferably off
/// the `marks` (all those of the plot). No two boxes overlap. Nothing for a name without room.
std::vector<std::optional<NamePlace>> place_names(std::span<const NamedMark> names,
                                                  std::span<const Vec2> marks,
                                                  const PixelBox& frame);

}  // namespace cigsim
