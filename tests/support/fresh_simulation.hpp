// SPDX-License-Identifier: MIT
// SystemC allows no new modules once it has run; this begins anew, so that several tests of one
// program can simulate. Modules, signals and events made before must have been destroyed.
#pragma once

#include <systemc>
#include <vector>

namespace cigsim::test {

inline void fresh_simulation() {
  static std::vector<sc_core::sc_simcontext*> used;  // SystemC cannot destroy one that has run
  used.push_back(sc_core::sc_curr_simcontext);
  sc_core::sc_curr_simcontext = sc_core::sc_default_global_context = new sc_core::sc_simcontext;
}

}  // namespace cigsim::test
