// SPDX-License-Identifier: MIT
// A bench for a stage at the timed or the clocked level: links with random stalls, feeders and
// drains with random pauses, transactors where the stage has pins, and the history of each link.
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <systemc>
#include <vector>

#include "models/boundary/trace_words.hpp"
#include "models/boundary/transactors.hpp"
#include "models/environment/random.hpp"

namespace cigsim::test {

/// Random waits that depend on nothing but a seed, a name and a number, so that every level of a
/// stage meets the same ones. A name has none at all, small ones, or now and then long ones.
class Waits {
 public:
  explicit Waits(unsigned seed) : seed_(seed) {}
  /// Never any.
  static Waits none() {
    Waits waits(0);
    waits.none_ = true;
    return waits;
  }
  Cycle operator()(const std::string& name, std::uint64_t number) const {
    if (none_) return 0;
    const std::uint64_t stream = mix(seed_ + std::hash<std::string>{}(name));
    const std::uint64_t value = mix(stream + number + 1);
    switch (stream % 4) {
      case 0:
      case 1:
        return 0;
      case 2:
        return static_cast<Cycle>(value % 4);
      default:
        return value % 16 == 0 ? static_cast<Cycle>(value / 16 % 40) : 0;
    }
  }

 private:
  static std::uint64_t mix(std::uint64_t x) { return Random(x).bits(); }

  unsigned seed_;
  bool none_ = false;
};

template <class T>
struct Handover {
  T word;
  Cycle pushed, taken;
  friend bool operator==(const Handover&, const Handover&) = default;
};
template <class T>
void PrintTo(const Handover<T>& h, std::ostream* out) {
  *out << h.word << " in " << h.pushed << " out " << h.taken;
}
template <class T>
using History = std::vector<Handover<T>>;

/// A link that records its words.
template <class T>
class RecordedLink {
 public:
  RecordedLink(const std::string& name, std::uint32_t depth, const Waits& waits)
      : link(name, depth, waits) {
    link.set_probe([this](const T& word, Cycle pushed, Cycle taken) {
      history.push_back({word, pushed, taken});
    });
  }
  Link<T> link;
  History<T> history;
};

/// Pushes words as soon as the pauses between them allow.
template <class T>
class Feeder : public sc_core::sc_module {
 public:
  Feeder(sc_core::sc_module_name name, Link<T>& link, const std::vector<T>& words,
         const Waits& waits)
      : sc_module(name), link_(link), words_(words), waits_(waits) {
    SC_HAS_PROCESS(Feeder);
    SC_THREAD(run);
  }

 private:
  void run() {
    Cycle at = -1;
    for (std::size_t i = 0; i < words_.size(); ++i)
      at = link_.push_from(words_[i], at + 1 + waits_(link_.name() + " feeder", i));
  }
  Link<T>& link_;
  const std::vector<T>& words_;
  Waits waits_;
};

/// Takes words for ever, as soon as the pauses between them allow.
template <class T>
class Drain : public sc_core::sc_module {
 public:
  Drain(sc_core::sc_module_name name, Link<T>& link, const Waits& waits)
      : sc_module(name), link_(link), waits_(waits) {
    SC_HAS_PROCESS(Drain);
    SC_THREAD(run);
  }

 private:
  void run() {
    Cycle at = -1;
    for (std::uint64_t i = 0;; ++i) {
      at = std::max(link_.available(), at + 1 + waits_(link_.name() + " drain", i));
      link_.take(at);
    }
  }
  Link<T>& link_;
  Waits waits_;
};

/// The cycle in which the last word was taken; -1: there was none.
template <class T>
Cycle last_taken(const History<T>& history) {
  return history.empty() ? -1 : history.back().taken;
}

/// Runs what is timed to its end, and then the clock, for what is clocked, until shortly after the
/// cycle that `last` tells by then.
template <class Last>
void run_timed_then_clocked(Clock& clock, Last last) {
  sc_core::sc_start();
  clock.start();
  sc_core::sc_start(static_cast<double>(last() + 10) * clock.period());
  clock.stop();
}

/// Owns the modules and wires of a bench.
class Parts {
 public:
  template <class M, class... A>
  M& make(A&&... arguments) {
    auto part =
        std::make_unique<M>(sc_core::sc_gen_unique_name("part"), std::forward<A>(arguments)...);
    M& made = *part;
    parts_.push_back(std::move(part));
    return made;
  }
  /// From a link to a stage's pins.
  template <class T>
  void connect(const Clock& clock, Link<T>& link, PinIn<T>& pins) {
    wires_.push_back(std::make_shared<Wires<T>>(make<LinkToPins<T>>(clock, link).out, pins));
  }
  /// From a stage's pins to a link.
  template <class T>
  void connect(const Clock& clock, PinOut<T>& pins, Link<T>& link) {
    wires_.push_back(std::make_shared<Wires<T>>(pins, make<PinsToLink<T>>(clock, link).in));
  }
  /// From pins to pins through a link.
  template <class T>
  void connect(const Clock& clock, PinOut<T>& from, Link<T>& link, PinIn<T>& to) {
    auto& both = make<ClockedLink<T>>(clock, link);
    wires_.push_back(std::make_shared<Wires<T>>(from, both.in));
    wires_.push_back(std::make_shared<Wires<T>>(both.out, to));
  }

 private:
  std::vector<std::shared_ptr<void>> wires_;
  std::vector<std::unique_ptr<sc_core::sc_module>> parts_;
};

}  // namespace cigsim::test
