// SPDX-License-Identifier: MIT
#include "Vmicrosequencer.h"
#include "rtl/common/microsequencer.pins.hpp"
#include "rtl/common/shim.hpp"

namespace cigsim::rtl::microsequencer {

void drive(Vmicrosequencer& module, const Pins& pins) {
  module.rst_i = pins.rst_i;
  module.op_i = pins.op_i;
  module.pass_i = pins.pass_i;
  module.d_i = pins.d_i;
}

void sample(const Vmicrosequencer& module, Pins& pins) {
  pins.micro_address_o = module.micro_address_o;
  pins.counter_o = module.counter_o;
  pins.stack_top_o = module.stack_top_o;
  pins.stack_level_o = module.stack_level_o;
}

}  // namespace cigsim::rtl::microsequencer

CIGSIM_RTL_LIBRARY(Vmicrosequencer, cigsim::rtl::microsequencer::Pins)
