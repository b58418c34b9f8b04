// SPDX-License-Identifier: MIT
// Two models of a stage on the same input pins: their output pins must agree in every cycle, and
// words as long as they are offered. One checker a stage, attached from outside.
#pragma once

#include <deque>
#include <functional>
#include <sstream>
#include <string>
#include <systemc>
#include <utility>
#include <vector>

#include "models/boundary/clock.hpp"
#include "models/boundary/mismatch.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/trace_words.hpp"

namespace cigsim {

class PinCheck : public sc_core::sc_module {
 public:
  /// `lines`: streams that end with a line, or a frame, are counted; so many are a frame. After the
  /// first difference, which `report` is told, it looks no more.
  PinCheck(sc_core::sc_module_name name, const Clock& clock, std::string stage, std::uint32_t lines,
           MismatchFunction report)
      : sc_module(name),
        clock_(clock),
        stage_(std::move(stage)),
        lines_(lines),
        report_(std::move(report)) {
    SC_HAS_PROCESS(PinCheck);
    SC_METHOD(check);
    dont_initialize();
    sensitive << clock_.wire.posedge_event();
  }

  /// An input of both: they must be ready alike.
  template <class T>
  void input(const std::string& name, const Wires<T>& wires,
             const sc_core::sc_signal<bool>& expected_ready) {
    inputs_.push_back([name, &wires] { return pins_text(name, wires); });
    checks_.push_back([this, name, &wires, &expected_ready] {
      compare(name + "_ready", expected_ready.read(), wires.ready.read());
      if (!wires.valid.read() || !wires.ready.read()) return;
      std::ostringstream text;
      text << name << " in cycle " << clock_.cycle() << ": " << wires.word.read();
      taken_.push_back(text.str());
      if (taken_.size() > kWordsKept) taken_.pop_front();
    });
  }

  /// An output: `wires` are those of the model in question, `expected` those of the other one. The
  /// last output to be added counts lines and frames.
  template <class T>
  void output(const std::string& name, const Wires<T>& wires, const Wires<T>& expected) {
    inputs_.push_back([name, &wires] { return name + "_ready " + bit(wires.ready.read()); });
    checks_.push_back([this, name, &wires, &expected] {
      const bool valid = wires.valid.read();
      compare(name + "_valid", expected.valid.read(), valid);
      if (!valid || !expected.valid.read()) return;
      compare_words(name + "_word", expected.word.read(), wires.word.read());
      if (wires.ready.read() && ends_stream(wires.word.read())) ++ended_;
    });
  }

  /// Words that were handed over to the stage's outputs end lines; so many have.
  std::uint64_t ended() const { return ended_; }
  /// A difference that shows elsewhere than on pins.
  void fail(const std::string& field, const std::string& expected, const std::string& got) {
    if (failed_) return;
    failed_ = true;
    Mismatch mismatch{
        stage_, field, clock_.cycle(), static_cast<std::uint32_t>(ended_ / lines_), {}, expected,
        got,    {}};
    if (lines_ > 1) mismatch.line = static_cast<std::uint32_t>(ended_ % lines_);
    for (const auto& input : inputs_) mismatch.inputs.push_back(input());
    mismatch.inputs.insert(mismatch.inputs.end(), taken_.begin(), taken_.end());
    report_(mismatch);
  }

 private:
  static constexpr std::size_t kWordsKept = 8;

  static std::string bit(bool value) { return value ? "1" : "0"; }

  template <class T>
  static std::string pins_text(const std::string& name, const Wires<T>& wires) {
    std::ostringstream text;
    text << name << "_valid " << bit(wires.valid.read()) << ", " << name << "_word "
         << wires.word.read();
    return text.str();
  }

  void check() {
    for (std::size_t i = 0; i < checks_.size() && !failed_; ++i) checks_[i]();
  }

  void compare(const std::string& field, bool expected, bool got) {
    if (expected != got) fail(field, bit(expected), bit(got));
  }
  template <class T>
  void compare_words(const std::string& field, const T& expected, const T& got) {
    if (expected == got) return;
    std::vector<std::pair<std::string, std::int64_t>> want;
    for_each_field(expected, [&](const char* name, const auto& value) {
      want.push_back({name, field_value(value)});
    });
    std::size_t at = 0;
    for_each_field(got, [&](const char*, const auto& value) {
      const auto& [name, wanted] = want[at++];
      if (wanted != field_value(value))
        fail(field + "." + name, std::to_string(wanted), std::to_string(field_value(value)));
    });
  }

  const Clock& clock_;
  std::string stage_;
  std::uint32_t lines_;
  MismatchFunction report_;
  std::vector<std::function<std::string()>> inputs_;
  std::vector<std::function<void()>> checks_;
  std::deque<std::string> taken_;
  std::uint64_t ended_ = 0;
  bool failed_ = false;
};

}  // namespace cigsim
