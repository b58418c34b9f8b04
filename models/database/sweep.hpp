// SPDX-License-Identifier: MIT
// Planes across the coordinate axes: at gaps between items, the cheapest that cut nothing, and at
// shares of the items' ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "models/database/work_set.hpp"

namespace cigsim {

/// Items in ascending order along an axis, in runs that planes across the axis part.
struct Sweep {
  int axis = 0;
  std::vector<std::uint32_t> order;
  std::vector<std::size_t> starts;  ///< first place of each run in `order`
  std::vector<double> positions;    ///< of the plane before run k + 1
  std::size_t largest = 0;          ///< items in the largest run
};

/// The sweep whose largest run is smallest; one run when no axis has a gap.
Sweep best_sweep(const WorkSet& set, const std::vector<std::uint32_t>& items);

/// Planes across x, then y, then z: along each axis, of the low and high ends of all items in
/// ascending order, through those that the given eighths of their number come before.
std::vector<Plane> planes_across_axes(const WorkSet& set, const std::vector<std::uint32_t>& items,
                                      std::span<const std::size_t> eighths);

}  // namespace cigsim
