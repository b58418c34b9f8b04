// SPDX-License-Identifier: MIT
// A link with what its two ends need: nothing for a timed stage, a transactor and wires for a
// clocked one or RTL.
#pragma once

#include <memory>
#include <string>

#include "models/boundary/clock.hpp"
#include "models/boundary/link.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/stuck_bit.hpp"
#include "models/boundary/words.hpp"

namespace cigsim {

template <class T>
class ClockedLink;
template <class T>
class PinsToLink;
template <class T>
class LinkToPins;

/// Of the words of words.hpp.
template <class T>
class Connection {
 public:
  /// `from_pins`, `to_pins`: whether producer and consumer are clocked.
  Connection(const std::string& name, std::uint32_t depth, const StallFunction& stalls,
             bool from_pins, bool to_pins, const Clock& clock);
  ~Connection();

  Link<T> link;

  /// Connects the pins of a clocked producer or consumer.
  void from(PinOut<T>& pins) { producer_.connect(pins); }
  void to(PinIn<T>& pins) { consumer_.connect(pins); }
  /// A producer, by pins of which a bit is stuck.
  void from(PinOut<T>& pins, const StuckBit& fault);

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

extern template class Connection<FrameWord>;
extern template class Connection<ItemWord>;
extern template class Connection<EdgeWord>;
extern template class Connection<FaceWord>;
extern template class Connection<CrossingWord>;
extern template class Connection<SpanWord>;

}  // namespace cigsim
