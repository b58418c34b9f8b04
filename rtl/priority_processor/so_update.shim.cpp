// SPDX-License-Identifier: MIT
#include "Vso_update.h"
#include "rtl/common/shim.hpp"
#include "rtl/priority_processor/so_update.pins.hpp"

namespace cigsim::rtl::so_update {

// Ports are as wide as the size says, at most 64 bits.
template <class Port, class Pin>
void put(Port& port, Pin pin) {
  port = static_cast<Port>(pin);
}

void drive(Vso_update& module, const Pins& pins) {
  module.rst_i = pins.rst_i;
  module.clear_i = pins.clear_i;
  module.column_valid_i = pins.column_valid_i;
  put(module.column_plane_i, pins.column_plane_i);
  put(module.column_tells_i, pins.column_tells_i);
  put(module.column_plus_i, pins.column_plus_i);
  module.side_valid_i = pins.side_valid_i;
  put(module.side_plane_i, pins.side_plane_i);
  module.side_plus_i = pins.side_plus_i;
  put(module.row_i, pins.row_i);
}

void sample(const Vso_update& module, Pins& pins) {
  pins.side_ready_o = module.side_ready_o;
  pins.row_hides_o = module.row_hides_o;
  pins.row_hidden_o = module.row_hidden_o;
  pins.row_unresolved_o = module.row_unresolved_o;
}

}  // namespace cigsim::rtl::so_update

CIGSIM_RTL_LIBRARY(Vso_update, cigsim::rtl::so_update::Pins)
