// SPDX-License-Identifier: MIT
// Pins of priority_resolver.sv.
#pragma once

#include <cstdint>

namespace cigsim::rtl::priority_resolver {

struct Pins {
  // inputs
  bool rst_i;
  std::uint16_t cfg_width_i;
  bool crossings_valid_i;
  std::uint32_t crossings_face_i;
  std::uint16_t crossings_element_i;
  bool crossings_left_i, crossings_end_i, crossings_cut_i;
  bool spans_ready_i;
  // outputs
  bool crossings_ready_o;
  bool spans_valid_o;
  std::uint32_t spans_face_o;
  bool spans_background_o;
  std::uint16_t spans_first_o, spans_end_o;
  bool spans_last_o;
  bool mon_entered_o, mon_taken_out_o, mon_too_small_o;
};

}  // namespace cigsim::rtl::priority_resolver
