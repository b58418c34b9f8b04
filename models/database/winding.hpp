// SPDX-License-Identifier: MIT
// Closing and orienting a set of faces by their shared edges.
#pragma once

#include "models/database/polygon.hpp"

namespace cigsim {

struct WindingResult {
  bool closed = false;
  std::uint32_t parts = 0;         ///< connected through shared edges
  std::uint64_t turned_faces = 0;  ///< faces whose winding was turned round
  std::uint64_t inserted = 0;      ///< vertices put into edges (T-junctions)
};

/// Repairs windings (rules in surface.hpp). Loops may gain corners and be reversed.
WindingResult repair_winding(std::span<const Vec3> vertices, std::vector<Loop>& loops);

}  // namespace cigsim
