// SPDX-License-Identifier: MIT
#include "Vpriority_processor.h"
#include "rtl/common/shim.hpp"
#include "rtl/priority_processor/priority_processor.pins.hpp"

namespace cigsim::rtl::priority_processor {

void drive(Vpriority_processor& module, const Pins& pins) {
  module.rst_i = pins.rst_i;
  module.cfg_object_capacity_i = pins.cfg_object_capacity_i;
  module.image_write_i = pins.image_write_i;
  module.image_address_i = static_cast<CData>(pins.image_address_i);
  module.image_word_i = pins.image_word_i;
  module.start_valid_i = pins.start_valid_i;
  module.start_frame_i = pins.start_frame_i;
  module.items_ready_i = pins.items_ready_i;
  module.memory_word_i = pins.memory_word_i;
  module.bank_word_i = pins.bank_word_i;
}

void sample(const Vpriority_processor& module, Pins& pins) {
  pins.start_ready_o = module.start_ready_o;
  pins.items_valid_o = module.items_valid_o;
  pins.items_set_o = module.items_set_o;
  pins.items_item_o = module.items_item_o;
  pins.items_end_o = module.items_end_o;
  pins.memory_address_o = module.memory_address_o;
  pins.bank_o = module.bank_o;
  pins.bank_address_o = module.bank_address_o;
  pins.mon_frame_o = module.mon_frame_o;
  pins.mon_record_o = module.mon_record_o;
  pins.mon_stalled_o = module.mon_stalled_o;
  pins.mon_dropped_o = module.mon_dropped_o;
  pins.mon_group_o = module.mon_group_o;
  pins.mon_plane_o = module.mon_plane_o;
  pins.mon_pair_o = module.mon_pair_o;
  pins.mon_fault_o = module.mon_fault_o;
}

}  // namespace cigsim::rtl::priority_processor

CIGSIM_RTL_LIBRARY(Vpriority_processor, cigsim::rtl::priority_processor::Pins)
