// SPDX-License-Identifier: MIT
// The SystemC library calls sc_main from the main function that it brings. Programs here have main
// functions of their own and drive the simulation with sc_start; for those without an sc_main this
// one stands in, and is never called.
#include <systemc>

int sc_main(int, char**) { return 0; }
