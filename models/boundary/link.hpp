// SPDX-License-Identifier: MIT
// A bounded timestamped link: the FIFO memory between two stages, at the transaction level.
//
// Timing (docs/machine.md, "Links", L1 to L3): a word pushed in cycle t can be taken from cycle
// t + 1 on; a full link has room again in the cycle after a word was taken. One word in and one
// word out a cycle at most. Producer and consumer are SystemC processes that run ahead of each
// other as far as the link lets them; the stamps tell when things happen, and SystemC's own time
// does not advance.
//
// When a word goes in follows from when it was offered, from the word before, and from the take
// that made room for it. A producer that need not know that cycle at once offers its words and
// runs on, also far beyond the link's depth; the cycles are found when the takes are known.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
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
      : name_(std::move(name)),
        depth_(depth),
        stalls_(std::move(stalls)),
        slots_(std::bit_ceil(std::size_t{depth} + kAhead)),
        mask_(slots_.size() - 1),
        taken_at_(std::bit_ceil(std::size_t{depth}), -1),
        taken_mask_(taken_at_.size() - 1) {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  const std::string& name() const { return name_; }
  std::uint32_t depth() const { return depth_; }
  void set_probe(Probe probe) { probe_ = std::move(probe); }

  // Producer, a SystemC thread.

  /// The first cycle in which the next word can be pushed. Waits (in SystemC's sense) until that is
  /// known.
  Cycle room() {
    while (!has_slot()) wait_for(taken_event_, producer_waits_);
    return room_now();
  }
  /// Pushes in cycle `at`, which must not be before room().
  void push(const T& word, Cycle at) {
    assert(has_slot() && at >= room_now());
    store(word, at);
    stamp();
    notify(pushed_event_, consumer_waits_);
  }
  /// Pushes in the first cycle from `from` on with room, and returns it.
  Cycle push_from(const T& word, Cycle from) {
    const Cycle at = std::max(from, room());
    push(word, at);
    return at;
  }
  /// As push_from, but does not wait for the cycle to be known.
  void offer(const T& word, Cycle from) {
    while (offered_ - taken_ == slots_.size()) wait_for(taken_event_, producer_waits_);
    store(word, from);
    notify(pushed_event_, consumer_waits_);
  }
  /// The cycle in which the last word offered or pushed goes in (-1: there was none). Waits until
  /// that is known.
  Cycle last_push() {
    while (offered_ - taken_ > depth_) wait_for(taken_event_, producer_waits_);
    stamp();
    return last_push_;
  }

  // Consumer, a SystemC thread.

  /// The first cycle in which the next word can be taken. Waits until there is a word.
  Cycle available() {
    while (!has_word()) wait_for(pushed_event_, consumer_waits_);
    return available_now();
  }
  /// The next word; call available() first.
  const T& front() const { return slots_[taken_ & mask_].word; }
  /// Takes the next word in cycle `at`, which must not be before available().
  void take(Cycle at) {
    assert(has_word() && at >= available_now());
    const Slot& slot = slots_[taken_ & mask_];
    if (probe_) probe_(slot.word, slot.pushed, at);
    taken_at_[taken_ & taken_mask_] = at;
    last_take_ = at;
    ++taken_;
    notify(taken_event_, producer_waits_);
  }

  // Both sides, without waiting (the transactors to pins).

  bool has_word() const { return taken_ != offered_; }
  /// Whether the cycle in which the next word can be pushed is known.
  bool has_slot() const { return offered_ - taken_ < depth_; }
  /// As available(), when has_word().
  Cycle available_now() {
    if (stamped_ == taken_) stamp();
    return std::max(last_take_ + 1, slots_[taken_ & mask_].visible);
  }
  /// As room(), when has_slot().
  Cycle room_now() {
    stamp();
    return std::max(last_push_, room_made(offered_)) + 1;
  }
  /// The event of the next push, or take. Ask anew each time: it is notified only when asked for.
  const sc_core::sc_event& next_push() {
    consumer_waits_ = true;
    return pushed_event_;
  }
  const sc_core::sc_event& next_take() {
    producer_waits_ = true;
    return taken_event_;
  }

 private:
  static constexpr std::size_t kAhead = 256;  ///< words that may be offered beyond the depth

  struct Slot {
    T word{};
    Cycle pushed = 0;  ///< until it is stamped: from when on it was offered
    Cycle visible = 0;
  };

  /// The cycle in which the word was taken that made room for word `index` (-1: there was room).
  Cycle room_made(std::uint64_t index) const { return taken_at_[(index - depth_) & taken_mask_]; }

  void store(const T& word, Cycle from) {
    Slot& slot = slots_[offered_ & mask_];
    slot.word = word;
    slot.pushed = from;
    ++offered_;
  }
  /// Finds the cycles of the pushes, as far as the takes that they depend on are known.
  void stamp() {
    for (; stamped_ != offered_ && stamped_ - taken_ < depth_; ++stamped_) {
      Slot& slot = slots_[stamped_ & mask_];
      last_push_ = std::max(slot.pushed, std::max(last_push_, room_made(stamped_)) + 1);
      slot.pushed = last_push_;
      slot.visible = last_push_ + 1;
      if (stalls_) slot.visible += stalls_(name_, stamped_);
    }
  }

  static void wait_for(const sc_core::sc_event& event, bool& waits) {
    waits = true;
    sc_core::wait(event);
  }
  static void notify(sc_core::sc_event& event, bool& waits) {
    if (!waits) return;
    waits = false;
    event.notify(sc_core::SC_ZERO_TIME);
  }

  std::string name_;
  std::uint32_t depth_;
  StallFunction stalls_;
  Probe probe_;
  std::vector<Slot> slots_;
  std::uint64_t mask_;
  std::vector<Cycle> taken_at_;
  std::uint64_t taken_mask_;
  std::uint64_t offered_ = 0, stamped_ = 0, taken_ = 0;  ///< how many; stamped_ <= offered_
  Cycle last_push_ = -1, last_take_ = -1;
  bool producer_waits_ = false, consumer_waits_ = false;
  sc_core::sc_event pushed_event_, taken_event_;
};

}  // namespace cigsim
