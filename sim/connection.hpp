// SPDX-License-Identifier: MIT
// A link with what its two ends need: nothing for a timed stage, a transactor and wires for a
// clocked one or RTL.
#pragma once

#include <memory>
#include <string>

#include "models/boundary/stuck_bit.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/boundary/transactors.hpp"

namespace cigsim {

template <class T>
class Connection {
 public:
  /// `from_pins`, `to_pins`: whether producer and consumer are clocked.
  Connection(const std::string& name, std::uint32_t depth, const StallFunction& stalls,
             bool from_pins, bool to_pins, const Clock& clock)
      : link(name, depth, stalls) {
    const std::string module = name + "_link";
    if (from_pins && to_pins) {
      both_ = std::make_unique<ClockedLink<T>>(module.c_str(), clock, link);
      producer_.connect(both_->in);
      consumer_.connect(both_->out);
    } else if (from_pins) {
      sink_ = std::make_unique<PinsToLink<T>>(module.c_str(), clock, link);
      producer_.connect(sink_->in);
    } else if (to_pins) {
      source_ = std::make_unique<LinkToPins<T>>(module.c_str(), clock, link);
      consumer_.connect(source_->out);
    }
  }

  Link<T> link;

  /// Connects the pins of a clocked producer or consumer.
  void from(PinOut<T>& pins) { producer_.connect(pins); }
  void to(PinIn<T>& pins) { consumer_.connect(pins); }
  /// A producer, by pins of which a bit is stuck.
  void from(PinOut<T>& pins, const StuckBit& fault) {
    pins.valid(sound_.valid);
    pins.word(sound_.word);
    pins.ready(producer_.ready);
    fault_ =
        std::make_unique<StuckPins<T>>((link.name() + "_fault").c_str(), fault, sound_, producer_);
  }

  /// What is connected to the producer, and to the consumer.
  Wires<T>& producer() { return producer_; }
  Wires<T>& consumer() { return consumer_; }

 private:
  std::unique_ptr<ClockedLink<T>> both_;
  std::unique_ptr<PinsToLink<T>> sink_;
  std::unique_ptr<LinkToPins<T>> source_;
  std::unique_ptr<StuckPins<T>> fault_;
  Wires<T> producer_, consumer_;
  Wires<T> sound_;  // ahead of the stuck bit
};

}  // namespace cigsim
