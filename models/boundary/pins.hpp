// SPDX-License-Identifier: MIT
// Pins of the clocked level: a word is handed over in a cycle in which both `valid` and `ready` are
// high. `valid` never waits for `ready`, and once high it stays, with the word, until taken.
//
// Cycle n ends at the n-th rising clock edge (counted from 0). A process on the rising edge reads
// the pins of cycle n and sets those of cycle n + 1.
#pragma once

#include <systemc>

namespace cigsim {

template <class T>
struct PinIn {
  sc_core::sc_in<bool> valid{"valid"};
  sc_core::sc_in<T> word{"word"};
  sc_core::sc_out<bool> ready{"ready"};
};

template <class T>
struct PinOut {
  sc_core::sc_out<bool> valid{"valid"};
  sc_core::sc_out<T> word{"word"};
  sc_core::sc_in<bool> ready{"ready"};
};

/// The wires between a PinOut and a PinIn.
template <class T>
struct Wires {
  sc_core::sc_signal<bool> valid, ready;
  sc_core::sc_signal<T> word;
};

}  // namespace cigsim
