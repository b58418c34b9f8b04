// SPDX-License-Identifier: MIT
// Runs the tests of a program that simulates with SystemC.
#include <gtest/gtest.h>

#include <cstdlib>
#include <systemc>

// SystemC cannot destroy a simulation that has run.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libsystemc"; }

int sc_main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

int main(int argc, char** argv) {
  setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
  return sc_core::sc_elab_and_sim(argc, argv);
}
