// SPDX-License-Identifier: MIT
#include "Vedge_orderer.h"
#include "rtl/common/shim.hpp"
#include "rtl/edge_orderer/edge_orderer.pins.hpp"

namespace cigsim::rtl::edge_orderer {

void drive(Vedge_orderer& module, const Pins& pins) {
  module.rst_i = pins.rst_i;
  module.cfg_width_i = pins.cfg_width_i;
  module.cfg_height_i = pins.cfg_height_i;
  module.cfg_crossing_capacity_i = pins.cfg_crossing_capacity_i;
  module.cfg_policy_i = pins.cfg_policy_i;
  module.edges_valid_i = pins.edges_valid_i;
  module.edges_face_i = pins.edges_face_i;
  module.edges_first_line_i = pins.edges_first_line_i;
  module.edges_end_line_i = pins.edges_end_line_i;
  module.edges_left_i = pins.edges_left_i;
  module.edges_end_i = pins.edges_end_i;
  module.edges_x_i = pins.edges_x_i;
  module.edges_slope_i = pins.edges_slope_i;
  module.loaded_ready_i = pins.loaded_ready_i;
  module.start_valid_i = pins.start_valid_i;
  module.start_frame_i = pins.start_frame_i;
  module.crossings_ready_i = pins.crossings_ready_i;
}

void sample(const Vedge_orderer& module, Pins& pins) {
  pins.edges_ready_o = module.edges_ready_o;
  pins.loaded_valid_o = module.loaded_valid_o;
  pins.loaded_frame_o = module.loaded_frame_o;
  pins.start_ready_o = module.start_ready_o;
  pins.crossings_valid_o = module.crossings_valid_o;
  pins.crossings_face_o = module.crossings_face_o;
  pins.crossings_element_o = module.crossings_element_o;
  pins.crossings_left_o = module.crossings_left_o;
  pins.crossings_end_o = module.crossings_end_o;
  pins.crossings_cut_o = module.crossings_cut_o;
  pins.mon_pass_o = module.mon_pass_o;
  pins.mon_line_o = module.mon_line_o;
  pins.mon_crossings_o = module.mon_crossings_o;
  pins.mon_overfull_o = module.mon_overfull_o;
  pins.mon_dropped_o = module.mon_dropped_o;
  pins.mon_overflow_o = module.mon_overflow_o;
  pins.mon_too_small_o = module.mon_too_small_o;
}

}  // namespace cigsim::rtl::edge_orderer

CIGSIM_RTL_LIBRARY(Vedge_orderer, cigsim::rtl::edge_orderer::Pins)
