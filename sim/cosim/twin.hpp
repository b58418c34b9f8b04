// SPDX-License-Identifier: MIT
// A clocked stage beside the one that is in the pipeline: it sees the same inputs, and what it puts
// out, in every cycle, is what is expected of the other one.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/boundary/pin_check.hpp"
#include "sim/pipeline/connection.hpp"

namespace cigsim {

/// `Model` is a stage at the clocked level, `Figures` what it tells of a frame.
template <class Model, class Figures>
class Twin {
 public:
  /// `make(name, figures)` makes the model. `stage` is the name of the one in the pipeline.
  template <class Make>
  Twin(const std::string& stage, Clock& clock, std::uint32_t lines, MismatchFunction report,
       Make make)
      : check_((stage + "_check").c_str(), clock, stage, lines, std::move(report)),
        model_(make((stage + "_twin").c_str(),
                    [this](const Figures& figures) { add(figures, got_, expected_); })) {
    model_->clock(clock.wire);
  }

  Model& model() { return *model_; }
  const Model& model() const { return *model_; }

  /// Its pins of a link, and what they are called.
  template <class T>
  void input(const std::string& name, PinIn<T>& pins, Connection<T>& connection) {
    auto ready = std::make_shared<sc_core::sc_signal<bool>>();
    pins.valid(connection.consumer().valid);
    pins.word(connection.consumer().word);
    pins.ready(*ready);
    check_.input(name, connection.consumer(), *ready);
    signals_.push_back(ready);
  }
  template <class T>
  void output(const std::string& name, PinOut<T>& pins, Connection<T>& connection) {
    auto wires = std::make_shared<Wires<T>>();
    pins.valid(wires->valid);
    pins.word(wires->word);
    pins.ready(connection.producer().ready);
    check_.output(name, connection.producer(), *wires);
    signals_.push_back(wires);
  }

  /// What the stage in the pipeline told.
  void figures(const Figures& figures) { add(figures, expected_, got_); }

 private:
  // Whichever of the two tells later compares.
  void add(const Figures& figures, std::deque<Figures>& other, std::deque<Figures>& own) {
    if (other.empty()) return own.push_back(figures);
    if (!(other.front() == figures)) check_.fail("figures of the frame", "as clocked", "others");
    other.pop_front();
  }

  std::vector<std::shared_ptr<void>> signals_;
  PinCheck check_;
  std::deque<Figures> expected_, got_;
  std::unique_ptr<Model> model_;
};

}  // namespace cigsim
