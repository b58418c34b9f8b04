// SPDX-License-Identifier: MIT
// A bounded timestamped link: the FIFO memory between two stages, at the transaction level.
//
// Timing (docs/machine.md, "Links"): a word pushed in cycle t can be taken from cycle t + 1 on; a
// full link has room again in the cycle after a word was taken. One word in and one word out a
// cycle at most. Producer and consumer are SystemC processes that run ahead of each other as far as
// the link lets them; the stamps tell when things happen, and SystemC's own time does not advance.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <systemc>
#include <vector>

#include "models/boundary/cycle.hpp"

namespace cigsim {

/// Holds words back for some cycles more (the stall fuzzer): which link, which word of it.
using StallFunction = std::function<Cycle(const std::string& link, std::uint64_t word)>;

template <class T>
class Link {
 public:
  /// Sees every word in order, when it is taken.
  using Probe = std::function<void(const T& word, Cycle pushed, Cycle taken)>;

  /// `depth`: words that the link holds, >= 1.
  Link(std::string name, std::uint32_t depth, StallFunction stalls = {})
      : name_(std::move(name)), depth_(depth), stalls_(std::move(stalls)), ring_(depth) {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  const std::string& name() const { return name_; }
  std::uint32_t depth() const { return depth_; }
  void set_probe(Probe probe) { probe_ = std::move(probe); }

  // Producer, a SystemC thread.

  /// The first cycle in which the next word can be pushed. Waits (in SystemC's sense) until that is
  /// known.
  Cycle room() {
    while (pushed_ - taken_ == depth_) wait_for(taken_event_, producer_waits_);
    return std::max(last_push_ + 1, ring_[pushed_ % depth_].taken + 1);
  }
  /// Pushes in cycle `at`, which must not be before room().
  void push(const T& word, Cycle at) {
    Slot& slot = ring_[pushed_ % depth_];
    slot.word = word;
    slot.pushed = at;
    slot.visible = at + 1;
    if (stalls_) slot.visible += stalls_(name_, pushed_);
    last_push_ = at;
    ++pushed_;
    notify(pushed_event_, consumer_waits_);
  }
  /// Pushes in the first cycle from `from` on with room, and returns it.
  Cycle push_from(const T& word, Cycle from) {
    const Cycle at = std::max(from, room());
    push(word, at);
    return at;
  }

  // Consumer, a SystemC thread.

  /// The first cycle in which the next word can be taken. Waits until there is a word.
  Cycle available() {
    while (pushed_ == taken_) wait_for(pushed_event_, consumer_waits_);
    return std::max(last_take_ + 1, ring_[taken_ % depth_].visible);
  }
  /// The next word; call available() first.
  const T& front() const { return ring_[taken_ % depth_].word; }
  /// Takes the next word in cycle `at`, which must not be before available().
  void take(Cycle at) {
    Slot& slot = ring_[taken_ % depth_];
    if (probe_) probe_(slot.word, slot.pushed, at);
    slot.taken = at;
    last_take_ = at;
    ++taken_;
    notify(taken_event_, producer_waits_);
  }

  // Both sides, without waiting (the transactors to pins).

  bool has_word() const { return pushed_ != taken_; }
  bool has_slot() const { return pushed_ - taken_ != depth_; }
  sc_core::sc_event& pushed_event() { return pushed_event_; }
  sc_core::sc_event& taken_event() { return taken_event_; }

 private:
  struct Slot {
    T word{};
    Cycle pushed = -1, visible = 0;
    Cycle taken = -1;  ///< when the word before was taken from this slot
  };

  static void wait_for(sc_core::sc_event& event, bool& waits) {
    waits = true;
    sc_core::wait(event);
    waits = false;
  }
  static void notify(sc_core::sc_event& event, bool waits) {
    if (waits) event.notify(sc_core::SC_ZERO_TIME);
  }

  std::string name_;
  std::uint32_t depth_;
  StallFunction stalls_;
  Probe probe_;
  std::vector<Slot> ring_;
  std::uint64_t pushed_ = 0, taken_ = 0;
  Cycle last_push_ = -1, last_take_ = -1;
  bool producer_waits_ = false, consumer_waits_ = false;
  sc_core::sc_event pushed_event_, taken_event_;
};

}  // namespace cigsim
