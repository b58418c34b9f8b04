// SPDX-License-Identifier: MIT
// The pins of microsequencer.sv.
#pragma once

#include <cstdint>

namespace cigsim::rtl::microsequencer {

struct Pins {
  // In.
  bool rst_i;
  std::uint8_t op_i;
  bool pass_i;
  std::uint16_t d_i;

  // Out.
  std::uint16_t micro_address_o;
  std::uint16_t counter_o;
  std::uint16_t stack_top_o;
  std::uint8_t stack_level_o;
};

}  // namespace cigsim::rtl::microsequencer
