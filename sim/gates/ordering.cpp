// SPDX-License-Identifier: MIT
#include "sim/gates/ordering.hpp"

namespace cigsim::gates {

std::uint64_t steps_for(Way way, std::uint64_t objects, std::uint64_t width) {
  const std::uint64_t parts = (objects + width - 1) / width;
  switch (way) {
    case Way::kPair:
      return objects * (objects - 1) / 2;
    case Way::kRow:
      return objects * parts;
    case Way::kMatrix:
      return parts * parts;
  }
  return 0;
}

std::uint64_t objects_in(Way way, std::uint64_t steps, std::uint64_t width) {
  if (steps == 0) return 0;
  std::uint64_t low = 1, high = width * (steps + 1) + 1;  // enough, and too many
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (steps_for(way, middle, width) <= steps ? low : high) = middle;
  }
  return low;
}

}  // namespace cigsim::gates
