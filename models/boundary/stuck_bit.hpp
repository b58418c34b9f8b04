// SPDX-License-Identifier: MIT
// A fault on purpose: a bit of a stage's output pins that is stuck, as by a broken wire of the back
// plane. Comparisons must find it.
#pragma once

#include <cstdint>
#include <string>
#include <systemc>

#include "models/boundary/fields.hpp"
#include "models/boundary/pins.hpp"

namespace cigsim {

struct StuckBit {
  std::string pins;   ///< of the stage: "spans"
  std::string field;  ///< "valid", or a field of the word
  unsigned bit = 0;
  bool high = false;
};

/// Sits between a stage's output pins (`from`) and the wires of its link (`to`).
template <class T>
class StuckPins : public sc_core::sc_module {
 public:
  StuckPins(sc_core::sc_module_name name, const StuckBit& fault, const Wires<T>& from, Wires<T>& to)
      : sc_module(name), fault_(fault), from_(from), to_(to) {
    SC_HAS_PROCESS(StuckPins);
    SC_METHOD(pass);
    sensitive << from_.valid << from_.word;
  }

 private:
  template <class Field>
  void stick(Field& field) const {
    const std::uint64_t mask = std::uint64_t{1} << fault_.bit;
    const auto bits = static_cast<std::uint64_t>(field);
    field = static_cast<Field>(fault_.high ? bits | mask : bits & ~mask);
  }
  void pass() {
    bool valid = from_.valid.read();
    T word = from_.word.read();
    if (fault_.field == "valid") stick(valid);
    for_each_field(word, [this](const char* name, auto& field) {
      if (fault_.field == name) stick(field);
    });
    to_.valid.write(valid);
    to_.word.write(word);
  }

  StuckBit fault_;
  const Wires<T>& from_;
  Wires<T>& to_;
};

}  // namespace cigsim
