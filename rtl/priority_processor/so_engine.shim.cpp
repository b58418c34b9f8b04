// SPDX-License-Identifier: MIT
#include "Vso_engine.h"
#include "rtl/common/shim.hpp"
#include "rtl/common/words.hpp"
#include "rtl/priority_processor/so_engine.pins.hpp"

namespace cigsim::rtl::so_engine {

void drive(Vso_engine& module, const Pins& pins) {
  module.rst_i = pins.rst_i;
  from_words(&pins.cfg_last_row_i, module.cfg_last_row_i);
  module.row_valid_i = pins.row_valid_i;
  if (pins.row_valid_i) {
    from_words(&pins.row_index_i, module.row_index_i);
    from_words(pins.row_tells_i, module.row_tells_i);
    from_words(pins.row_plus_i, module.row_plus_i);
  }
  module.start_valid_i = pins.start_valid_i;
  if (pins.start_valid_i) {
    from_words(pins.start_eye_i, module.start_eye_i);
    from_words(pins.start_active_i, module.start_active_i);
  }
}

void sample(const Vso_engine& module, Pins& pins) {
  pins.start_ready_o = module.start_ready_o;
  pins.answer_valid_o = module.answer_valid_o;
  to_words(module.answer_row_o, &pins.answer_row_o);
  to_words(module.answer_hides_o, pins.answer_hides_o);
  to_words(module.answer_hidden_o, pins.answer_hidden_o);
  to_words(module.answer_unresolved_o, pins.answer_unresolved_o);
  to_words(module.answer_count_o, &pins.answer_count_o);
  pins.answer_last_o = module.answer_last_o;
  pins.answer_unique_o = module.answer_unique_o;
  pins.answer_resolved_o = module.answer_resolved_o;
}

}  // namespace cigsim::rtl::so_engine

CIGSIM_RTL_LIBRARY(Vso_engine, cigsim::rtl::so_engine::Pins)
