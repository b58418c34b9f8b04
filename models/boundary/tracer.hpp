// SPDX-License-Identifier: MIT
// What a clocked stage shows in waves: its pins and registers, under the name of its module.
#pragma once

#include <string>
#include <systemc>

#include "models/boundary/trace_words.hpp"

namespace cigsim {

/// For use after elaboration, when ports are bound.
class Tracer {
 public:
  Tracer(sc_core::sc_trace_file* file, const sc_core::sc_module& module)
      : file_(file), scope_(std::string(module.name()) + ".") {}

  /// A port or a signal.
  template <class Pin>
  void pin(const Pin& pin, const std::string& name) const {
    sc_trace(file_, pin.read(), scope_ + name);
  }
  /// A PinIn or a PinOut.
  template <class Bundle>
  void pins(const Bundle& bundle, const std::string& name) const {
    pin(bundle.valid, name + "_valid");
    pin(bundle.ready, name + "_ready");
    pin(bundle.word, name + "_word");
  }
  /// A register, which must outlive the file.
  template <class Register, class... Width>
  void state(const Register& value, const std::string& name, Width... width) const {
    sc_core::sc_trace(file_, value, scope_ + name, width...);
  }

 private:
  sc_core::sc_trace_file* file_;
  std::string scope_;
};

}  // namespace cigsim
