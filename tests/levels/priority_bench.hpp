// SPDX-License-Identifier: MIT
// The priority processor at its levels side by side, fed and held back alike.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "models/boundary/transactors.hpp"
#include "models/environment/random.hpp"
#include "models/priority_processor/clocked.hpp"
#include "models/priority_processor/rtl.hpp"
#include "models/priority_processor/timed.hpp"

namespace cigsim::test {

/// Two banks and what happens on the links. Frame k reads bank k mod 2.
struct PriorityCase {
  MachineDescription machine;
  std::vector<std::unique_ptr<priority_processor::PriorityMemory>> memories;
  std::vector<priority_processor::PriorityBank> filled;  ///< two
  std::uint32_t frames = 2;
  Cycle start_gap = 0;       ///< between start words at least
  std::uint64_t pauses = 0;  ///< seed of random pauses and stalls, 0: none

  std::array<priority_processor::PriorityBank, 2> banks() const { return {filled[0], filled[1]}; }
};

struct ItemHandover {
  ItemWord word;
  Cycle pushed = 0, taken = 0;
  friend bool operator==(const ItemHandover&, const ItemHandover&) = default;
};
inline void PrintTo(const ItemHandover& h, std::ostream* out) {
  *out << h.word << " in " << h.pushed << " out " << h.taken;
}

/// One level of the stage between a process that pushes start words and one that takes items.
class PriorityBench {
 public:
  enum Level { kTimed, kClocked };

  PriorityBench(const PriorityCase& c, Level level, const Clock& clock) : PriorityBench(c) {
    if (level == kTimed) {
      timed_ = std::make_unique<priority_processor::Timed>(
          name(), c.machine, priority_processor::Timed::Links{start_, items_}, banks_, report());
      return;
    }
    clocked =
        std::make_unique<priority_processor::Clocked>(name(), c.machine, clock, banks_, report());
    connect(*clocked, clock);
  }
  /// The RTL level. `seed` as that of priority_processor::Rtl.
  PriorityBench(const PriorityCase& c, const std::filesystem::path& library, std::uint32_t seed,
                const Clock& clock)
      : PriorityBench(c) {
    rtl = std::make_unique<priority_processor::Rtl>(name(), c.machine, clock, banks_, library,
                                                    report(), seed);
    connect(*rtl, clock);
  }
  PriorityBench(const PriorityBench&) = delete;

  bool done() const { return figures.size() == case_.frames && ends_ == case_.frames; }
  /// Between links and pins, at all levels but the timed one.
  const Wires<FrameWord>& start_wires() const { return *start_wires_; }
  const Wires<ItemWord>& item_wires() const { return *item_wires_; }

  std::vector<ItemHandover> history;
  std::vector<priority_processor::Figures> figures;
  std::unique_ptr<priority_processor::Clocked> clocked;
  std::unique_ptr<priority_processor::Rtl> rtl;

 private:
  explicit PriorityBench(const PriorityCase& c)
      : case_(c),
        banks_(c.banks()),
        start_("start", 2, stalls(c.pauses)),
        items_("items", c.machine.links.items, stalls(c.pauses)) {
    items_.set_probe([this](const ItemWord& word, Cycle pushed, Cycle taken) {
      history.push_back({word, pushed, taken});
    });
    producer_ = std::make_unique<Producer>(name(), *this);
    consumer_ = std::make_unique<Consumer>(name(), *this);
  }

  priority_processor::FiguresFunction report() {
    return [this](const priority_processor::Figures& f) { figures.push_back(f); };
  }
  template <class Stage>
  void connect(Stage& stage, const Clock& clock) {
    stage.clock(clock.wire);
    in_ = std::make_unique<LinkToPins<FrameWord>>(name(), clock, start_);
    out_ = std::make_unique<PinsToLink<ItemWord>>(name(), clock, items_);
    start_wires_ = std::make_unique<Wires<FrameWord>>(in_->out, stage.start);
    item_wires_ = std::make_unique<Wires<ItemWord>>(stage.items, out_->in);
  }

  struct Producer : sc_core::sc_module {
    Producer(sc_core::sc_module_name name, PriorityBench& b) : sc_module(name), bench(b) {
      SC_HAS_PROCESS(Producer);
      SC_THREAD(run);
    }
    void run() {
      for (std::uint32_t k = 0; k < bench.case_.frames; ++k)
        bench.start_.push_from({k}, k * bench.case_.start_gap);
    }
    PriorityBench& bench;
  };
  struct Consumer : sc_core::sc_module {
    Consumer(sc_core::sc_module_name name, PriorityBench& b) : sc_module(name), bench(b) {
      SC_HAS_PROCESS(Consumer);
      SC_THREAD(run);
    }
    void run() {
      Random random(bench.case_.pauses);
      for (Cycle last = -1; bench.ends_ < bench.case_.frames;) {
        Cycle pause = 0;
        if (bench.case_.pauses != 0) pause = random.below(4) == 0 ? random.below(60) : 0;
        last = std::max(bench.items_.available(), last + 1 + pause);
        bench.ends_ += bench.items_.front().end;
        bench.items_.take(last);
      }
    }
    PriorityBench& bench;
  };

  static StallFunction stalls(std::uint64_t seed) {
    if (seed == 0) return {};
    return [seed](const std::string&, std::uint64_t word) {
      Random random(seed + word);
      return static_cast<Cycle>(random.below(3) == 0 ? random.below(20) : 0);
    };
  }
  static const char* name() { return sc_core::sc_gen_unique_name("part"); }

  const PriorityCase& case_;
  std::array<priority_processor::PriorityBank, 2> banks_;
  Link<FrameWord> start_;
  Link<ItemWord> items_;
  std::uint32_t ends_ = 0;
  std::unique_ptr<Producer> producer_;
  std::unique_ptr<Consumer> consumer_;
  std::unique_ptr<priority_processor::Timed> timed_;
  std::unique_ptr<LinkToPins<FrameWord>> in_;
  std::unique_ptr<PinsToLink<ItemWord>> out_;
  std::unique_ptr<Wires<FrameWord>> start_wires_;
  std::unique_ptr<Wires<ItemWord>> item_wires_;
};

/// Runs until all benches are done, or `cycles` have passed.
inline void run_benches(Clock& clock, const std::deque<PriorityBench>& benches, Cycle cycles) {
  clock.start();
  constexpr Cycle kStep = 1000;
  const auto done = [&] {
    for (const PriorityBench& bench : benches)
      if (!bench.done()) return false;
    return true;
  };
  for (Cycle n = 0; n < cycles && !done(); n += kStep)
    sc_core::sc_start(static_cast<double>(kStep) * clock.period());
  clock.stop();
}

}  // namespace cigsim::test
