// SPDX-License-Identifier: MIT
#include "models/geometry_processor/program.hpp"

#include <algorithm>
#include <limits>

#include "firmware/programs.hpp"

namespace cigsim::geometry_processor {

int quotient_clocks(const WordFormats& formats) { return formats.quotient_fraction / 2; }

// 13 whole bits, the fraction, and one bit to round by.
int slope_clocks(const WordFormats& formats) { return (13 + formats.raster_fraction + 1 + 1) / 2; }

firmware::Program program(const WordFormats& formats) {
  const int quotient = quotient_clocks(formats), slope = slope_clocks(formats);
  return firmware::stage_program("geometry_processor", {{"WAIT_COLUMN", std::max(0, quotient - 6)},
                                                        {"WAIT_LINE", std::max(0, quotient - 3)},
                                                        {"WAIT_FULL", std::max(0, quotient - 2)},
                                                        {"WAIT_SLOPE", std::max(0, slope - 9)}});
}

Cycle deadline(const MachineDescription& machine, OverloadPolicy overload) {
  if (overload == OverloadPolicy::kExtend || machine.frame_cycles == 0)
    return std::numeric_limits<Cycle>::max();
  return machine.frame_cycles - machine.deadline_margin;
}

}  // namespace cigsim::geometry_processor
