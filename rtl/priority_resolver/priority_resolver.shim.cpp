// SPDX-License-Identifier: MIT
#include "Vpriority_resolver.h"
#include "rtl/common/shim.hpp"
#include "rtl/priority_resolver/priority_resolver.pins.hpp"

namespace cigsim::rtl::priority_resolver {

void drive(Vpriority_resolver& module, const Pins& pins) {
  module.rst_i = pins.rst_i;
  module.cfg_width_i = pins.cfg_width_i;
  module.crossings_valid_i = pins.crossings_valid_i;
  module.crossings_face_i = pins.crossings_face_i;
  module.crossings_element_i = pins.crossings_element_i;
  module.crossings_left_i = pins.crossings_left_i;
  module.crossings_end_i = pins.crossings_end_i;
  module.crossings_cut_i = pins.crossings_cut_i;
  module.spans_ready_i = pins.spans_ready_i;
}

void sample(const Vpriority_resolver& module, Pins& pins) {
  pins.crossings_ready_o = module.crossings_ready_o;
  pins.spans_valid_o = module.spans_valid_o;
  pins.spans_face_o = module.spans_face_o;
  pins.spans_background_o = module.spans_background_o;
  pins.spans_first_o = module.spans_first_o;
  pins.spans_end_o = module.spans_end_o;
  pins.spans_last_o = module.spans_last_o;
  pins.mon_entered_o = module.mon_entered_o;
  pins.mon_taken_out_o = module.mon_taken_out_o;
  pins.mon_too_small_o = module.mon_too_small_o;
}

}  // namespace cigsim::rtl::priority_resolver

CIGSIM_RTL_LIBRARY(Vpriority_resolver, cigsim::rtl::priority_resolver::Pins)
