// SPDX-License-Identifier: MIT
// Where both hulls begin: extreme points, a tetrahedron, or the finding that there is none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/database/hull/exact_points.hpp"

namespace cigsim {

/// Points whose distance from one of Levine's seven planes x, y, z, x+y+z, −x+y+z, x+y−z, −x+y−z is
/// largest or smallest (ch. IV, step 1), each once, in that order; at most 14.
std::vector<std::uint32_t> extreme_points(const ExactPoints& points);

struct HullStart {
  /// What the points span: −1 nothing (no points), 0 to 3.
  int dimension = -1;
  /// dimension + 1 points that span it. Four: the last sees the others run clockwise.
  std::array<std::uint32_t, 4> corner{};
  /// For dimension 2, an axis along which the points' plane can be seen.
  int axis = 0;
  std::uint64_t tests = 0;  ///< distances from the plane of the first three
};

/// The first three extreme points that are not on one line, and the point farthest from their plane
/// (Levine 1975, ch. IV, steps 2 and 3); any points that will do where doubles see none.
HullStart find_start(const ExactPoints& points, const std::vector<std::uint32_t>& extreme);

}  // namespace cigsim
