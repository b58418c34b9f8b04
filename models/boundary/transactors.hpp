// SPDX-License-Identifier: MIT
// Between a link and pins, so that stages of any level are neighbours: LinkToPins is a link's
// consumer, PinsToLink its producer, ClockedLink both. Exactly rules L1 to L4 of docs/machine.md,
// whichever is used; `valid` and `ready` on the link's side are registers.
//
// Timed stages run ahead of the clock and never behind it. They act in the order of their stamps:
// what a process does after it waited for a link has stamps from the cycle on that it was told. By
// L2 and L3 that cycle is later than the push or take that it waited for. So when the edge that
// ends cycle n has come and all timed processes wait again, each waits, at the end of the chain,
// for a push or take by pins, which will have a stamp of n + 1 or later, and what timed processes
// then do has stamps of n + 2 or later. At the edge that ends cycle n + 1 therefore all that they
// do up to cycle n + 1 has been stamped, and the transactors decide on complete knowledge.
//
// A process that looks at no pin in the coming cycles sleeps, so that quiet links cost nothing.
#pragma once

#include "models/boundary/clock.hpp"
#include "models/boundary/link.hpp"
#include "models/boundary/pins.hpp"

namespace cigsim {

/// What the three have in common: a method on the rising edge.
class Transactor : public sc_core::sc_module {
 protected:
  Transactor(sc_core::sc_module_name name, const Clock& clock) : sc_module(name), clock_(clock) {
    SC_HAS_PROCESS(Transactor);
    SC_METHOD(run);
    dont_initialize();
    sensitive << clock_.wire.posedge_event();
  }

  /// Reads the pins of cycle n, and sets those of n + 1.
  virtual void edge(Cycle n) = 0;

  /// Not before the edge that ends cycle `next`.
  void sleep_until(Cycle next) {
    if (next > clock_.cycle() + kShortSleep) next_trigger(clock_.time_before(next));
  }

 private:
  static constexpr Cycle kShortSleep = 3;  ///< cycles that cost less awake

  void run() {
    // Woken from sleep between two edges, the method waits for the next.
    if (clock_.wire.posedge()) edge(clock_.cycle());
  }

  const Clock& clock_;
};

/// Consumer of a link: offers its words on `out`.
template <class T>
class LinkToPins : public Transactor {
 public:
  LinkToPins(sc_core::sc_module_name name, const Clock& clock, Link<T>& link)
      : Transactor(name, clock), link_(link) {}

  PinOut<T> out;

 private:
  void edge(Cycle n) override {
    if (valid_ && !out.ready.read()) return next_trigger(out.ready.posedge_event());
    if (valid_) link_.take(n);
    const bool word = link_.has_word();
    const Cycle next = word ? link_.available_now() : 0;
    assert(!word || next > n);  // else a timed producer was behind the clock
    valid_ = word && next <= n + 1;
    out.valid.write(valid_);
    if (valid_)
      out.word.write(link_.front());
    else if (word)
      sleep_until(next - 1);
    else
      next_trigger(link_.next_push());
  }

  Link<T>& link_;
  bool valid_ = false;
};

/// Producer of a link: takes the words that `in` offers.
template <class T>
class PinsToLink : public Transactor {
 public:
  PinsToLink(sc_core::sc_module_name name, const Clock& clock, Link<T>& link)
      : Transactor(name, clock), link_(link) {
    in.ready.initialize(true);
  }

  PinIn<T> in;

 private:
  void edge(Cycle n) override {
    const bool valid = in.valid.read();
    if (valid && ready_) link_.push(in.word.read(), n);
    const bool slot = link_.has_slot();
    const Cycle room = slot ? link_.room_now() : 0;
    assert(!slot || !valid || room > n);  // else a timed consumer was behind the clock
    ready_ = slot && room <= n + 1;
    in.ready.write(ready_);
    if (!slot)
      next_trigger(link_.next_take());
    else if (!ready_)
      sleep_until(room - 1);
    else if (!valid)
      next_trigger(in.valid.posedge_event());
  }

  Link<T>& link_;
  bool ready_ = true;
};

/// Both ends of a link between two clocked stages.
template <class T>
class ClockedLink : public Transactor {
 public:
  ClockedLink(sc_core::sc_module_name name, const Clock& clock, Link<T>& link)
      : Transactor(name, clock), link_(link) {
    in.ready.initialize(true);
  }

  PinIn<T> in;
  PinOut<T> out;

 private:
  void edge(Cycle n) override {
    const bool offered = in.valid.read();
    if (offered && ready_) link_.push(in.word.read(), n);
    if (valid_ && out.ready.read()) {
      link_.take(n);
      valid_ = false;
    }
    ready_ = link_.has_slot() && link_.room_now() <= n + 1;
    in.ready.write(ready_);
    const bool word = link_.has_word();
    if (!valid_ && word && link_.available_now() <= n + 1) {
      valid_ = true;
      out.word.write(link_.front());
    }
    out.valid.write(valid_);
    if (!word && !offered) next_trigger(in.valid.posedge_event());
  }

  Link<T>& link_;
  bool ready_ = true, valid_ = false;
};

}  // namespace cigsim
