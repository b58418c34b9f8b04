// SPDX-License-Identifier: MIT
// What the priority processor tells about a frame, in machine words at every level.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "models/boundary/activity.hpp"

namespace cigsim::priority_processor {

/// `dropped`: items beyond object_capacity.
struct Figures : StageFigures {
  std::uint64_t items = 0;            ///< put out
  std::uint64_t groups = 0;           ///< ordered, those of one active member too
  std::uint64_t planes = 0;           ///< tested
  std::uint64_t pairs = 0;            ///< looked at
  std::vector<std::uint32_t> faults;  ///< groups whose counts were not unique, as they came: places
                                      ///< in ActiveEnvironment::groups
  friend bool operator==(const Figures&, const Figures&) = default;
};

using FiguresFunction = std::function<void(const Figures&)>;

}  // namespace cigsim::priority_processor
