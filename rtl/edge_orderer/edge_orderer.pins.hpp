// SPDX-License-Identifier: MIT
// Pins of edge_orderer.sv.
#pragma once

#include <cstdint>

namespace cigsim::rtl::edge_orderer {

struct Pins {
  // inputs
  bool rst_i;
  std::uint16_t cfg_width_i, cfg_height_i;
  std::uint32_t cfg_crossing_capacity_i;
  std::uint8_t cfg_policy_i;
  bool edges_valid_i;
  std::uint32_t edges_face_i;
  std::uint16_t edges_first_line_i, edges_end_line_i;
  bool edges_left_i, edges_end_i;
  std::uint32_t edges_x_i, edges_slope_i;
  bool loaded_ready_i;
  bool start_valid_i;
  std::uint32_t start_frame_i;
  bool crossings_ready_i;
  // outputs
  bool edges_ready_o;
  bool loaded_valid_o;
  std::uint32_t loaded_frame_o;
  bool start_ready_o;
  bool crossings_valid_o;
  std::uint32_t crossings_face_o;
  std::uint16_t crossings_element_o;
  bool crossings_left_o, crossings_end_o, crossings_cut_o;
  bool mon_pass_o, mon_line_o;
  std::uint32_t mon_crossings_o;
  bool mon_overfull_o;
  std::uint32_t mon_dropped_o;
  bool mon_overflow_o, mon_too_small_o;
};

}  // namespace cigsim::rtl::edge_orderer
