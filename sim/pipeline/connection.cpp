// SPDX-License-Identifier: MIT
#include "sim/pipeline/connection.hpp"

#include "models/boundary/trace_words.hpp"
#include "models/boundary/transactors.hpp"

namespace cigsim {

template <class T>
Connection<T>::Connection(const std::string& name, std::uint32_t depth, const StallFunction& stalls,
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

template <class T>
Connection<T>::~Connection() = default;

template <class T>
void Connection<T>::from(PinOut<T>& pins, const StuckBit& fault) {
  pins.valid(sound_.valid);
  pins.word(sound_.word);
  pins.ready(producer_.ready);
  fault_ =
      std::make_unique<StuckPins<T>>((link.name() + "_fault").c_str(), fault, sound_, producer_);
}

template class Connection<FrameWord>;
template class Connection<ItemWord>;
template class Connection<EdgeWord>;
template class Connection<FaceWord>;
template class Connection<CrossingWord>;
template class Connection<SpanWord>;

}  // namespace cigsim
