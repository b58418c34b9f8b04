// SPDX-License-Identifier: MIT
// Gaps between items along a coordinate axis: the cheapest planes that cut nothing.
#pragma once

#include <cstdint>
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

}  // namespace cigsim
