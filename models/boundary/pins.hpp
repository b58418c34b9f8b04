// SPDX-License-Identifier: MIT
// Pins of the clocked level: a word is handed over in a cycle in which both `valid` and `ready` are
// high. `valid` never waits for `ready`, and once high it stays, with the word, until taken.
//
// Cycle n ends at the n-th rising clock edge (counted from 0). A process on the rising edge reads
// the pins of cycle n and sets those of cycle n + 1.
#pragma once

#include <string>
#include <systemc>

namespace cigsim {

/// A module with several bundles names them, so that its pins are in waves as `NAME_valid`, ….
template <class T>
struct PinIn {
  explicit PinIn(const std::string& name = "in")
      : valid((name + "_valid").c_str()),
        word((name + "_word").c_str()),
        ready((name + "_ready").c_str()) {}
  sc_core::sc_in<bool> valid;
  sc_core::sc_in<T> word;
  sc_core::sc_out<bool> ready;
};

template <class T>
struct PinOut {
  explicit PinOut(const std::string& name = "out")
      : valid((name + "_valid").c_str()),
        word((name + "_word").c_str()),
        ready((name + "_ready").c_str()) {}
  sc_core::sc_out<bool> valid;
  sc_core::sc_out<T> word;
  sc_core::sc_in<bool> ready;
};

/// The wires between a PinOut and a PinIn.
template <class T>
struct Wires {
  sc_core::sc_signal<bool> valid, ready;
  sc_core::sc_signal<T> word;

  Wires() = default;
  Wires(PinOut<T>& from, PinIn<T>& to) {
    connect(from);
    connect(to);
  }
  /// Connects one end: a PinOut or a PinIn.
  template <class Pins>
  void connect(Pins& pins) {
    pins.valid(valid);
    pins.word(word);
    pins.ready(ready);
  }
};

}  // namespace cigsim
