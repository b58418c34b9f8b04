// SPDX-License-Identifier: MIT
// Links and transactors: a producer, a relay and a consumer, each timed or on pins, in all mixes,
// against a model of two memories that is stepped cycle by cycle.
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <random>

#include "models/boundary/trace_words.hpp"
#include "models/boundary/transactors.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim {
namespace {

constexpr Cycle kClosed = 1 << 30;

/// What the three stages of a case do.
struct Plan {
  std::uint32_t depth[2] = {1, 1};
  bool absolute = false;  ///< gaps count from the schedule, and not from the word before
  std::vector<Cycle> gap, pause;
  std::vector<Cycle> stall[2];

  explicit Plan(unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](unsigned n) { return static_cast<Cycle>(random() % n); };
    for (std::uint32_t& d : depth) d = 1 + static_cast<std::uint32_t>(below(below(2) ? 3 : 20));
    absolute = below(2) == 1;
    const unsigned gaps = below(2) ? 1 : 6, pauses = below(2) ? 1 : 6, stalls = below(2) ? 1 : 5;
    for (int i = 0, words = 1 + static_cast<int>(below(60)); i < words; ++i) {
      gap.push_back(below(12) == 0 ? below(50) : below(gaps));
      pause.push_back(below(12) == 0 ? below(50) : below(pauses));
      for (auto& s : stall) s.push_back(below(10) == 0 ? below(30) : below(stalls));
    }
  }
};

struct Handover {
  std::uint32_t word;
  Cycle pushed, taken;
  friend bool operator==(const Handover&, const Handover&) = default;
};
void PrintTo(const Handover& h, std::ostream* out) {
  *out << "word " << h.word << " in " << h.pushed << " out " << h.taken;
}
using History = std::vector<Handover>;

/// The referee: every cycle, what each memory holds at its beginning decides.
void referee(const Plan& plan, History (&out)[2]) {
  const std::size_t words = plan.gap.size();
  struct Memory {
    std::deque<std::pair<std::uint32_t, Cycle>> held;  ///< word, pushed
  } memory[2];
  std::size_t sent = 0;
  Cycle offer = plan.gap[0], next_take = plan.pause[0];
  int relay = -1;  ///< the word in its output register
  for (Cycle now = 0; out[1].size() < words; ++now) {
    const bool room[2] = {memory[0].held.size() < plan.depth[0],
                          memory[1].held.size() < plan.depth[1]};
    const auto word_in = [&](int m) {
      return !memory[m].held.empty() &&
             now > memory[m].held.front().second + plan.stall[m][memory[m].held.front().first];
    };
    const bool word[2] = {word_in(0), word_in(1)};
    const auto take = [&](int m) {
      out[m].push_back({memory[m].held.front().first, memory[m].held.front().second, now});
      memory[m].held.pop_front();
      return static_cast<int>(out[m].back().word);
    };
    const bool relay_gives = relay >= 0 && room[1];
    const int given = relay;
    if (relay_gives) relay = -1;
    if (word[0] && relay < 0) relay = take(0);
    if (word[1] && now >= next_take) {
      take(1);
      if (out[1].size() < words) next_take = now + 1 + plan.pause[out[1].size()];
    }
    if (relay_gives) memory[1].held.push_back({static_cast<std::uint32_t>(given), now});
    if (sent < words && room[0] && now >= offer) {
      memory[0].held.push_back({static_cast<std::uint32_t>(sent), now});
      ++sent;
      if (sent < words) {
        if (!plan.absolute) offer = now;
        offer += 1 + plan.gap[sent];
      }
    }
  }
}

struct TimedProducer : sc_core::sc_module {
  TimedProducer(sc_core::sc_module_name name, const Plan& p, Link<FrameWord>& l)
      : sc_module(name), plan(p), link(l) {
    SC_HAS_PROCESS(TimedProducer);
    SC_THREAD(run);
  }
  void run() {
    Cycle at = -1;
    for (std::uint32_t i = 0; i < plan.gap.size(); ++i) {
      at += 1 + plan.gap[i];
      if (plan.absolute)
        link.offer({i}, at);
      else
        at = link.push_from({i}, at);
    }
    if (plan.absolute) last = link.last_push();
  }
  const Plan& plan;
  Link<FrameWord>& link;
  Cycle last = -1;
};

struct TimedRelay : sc_core::sc_module {
  TimedRelay(sc_core::sc_module_name name, Link<FrameWord>& i, Link<FrameWord>& o)
      : sc_module(name), in(i), out(o) {
    SC_HAS_PROCESS(TimedRelay);
    SC_THREAD(run);
  }
  void run() {
    for (Cycle pushed = 0;;) {
      const Cycle at = std::max(in.available(), pushed);
      const FrameWord word = in.front();
      in.take(at);
      pushed = out.push_from(word, at + 1);
    }
  }
  Link<FrameWord>&in, &out;
};

struct TimedConsumer : sc_core::sc_module {
  TimedConsumer(sc_core::sc_module_name name, const Plan& p, Link<FrameWord>& l)
      : sc_module(name), plan(p), link(l) {
    SC_HAS_PROCESS(TimedConsumer);
    SC_THREAD(run);
  }
  void run() {
    Cycle last = -1;
    for (const Cycle pause : plan.pause) {
      last = std::max(link.available(), last + 1 + pause);
      link.take(last);
    }
  }
  const Plan& plan;
  Link<FrameWord>& link;
};

struct PinProducer : sc_core::sc_module {
  PinProducer(sc_core::sc_module_name name, const Clock& c, const Plan& p)
      : sc_module(name), clock(c), plan(p), offer(p.gap[0]) {
    SC_HAS_PROCESS(PinProducer);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
    out.valid.initialize(offer == 0);
  }
  void edge() {
    const Cycle n = clock.cycle();
    if (out.valid.read() && out.ready.read()) {
      ++sent;
      if (sent < plan.gap.size()) offer = (plan.absolute ? offer : n) + 1 + plan.gap[sent];
    }
    const bool valid = sent < plan.gap.size() && n + 1 >= offer;
    out.valid.write(valid);
    out.word.write({valid ? static_cast<std::uint32_t>(sent) : 999});
  }
  PinOut<FrameWord> out;
  const Clock& clock;
  const Plan& plan;
  std::size_t sent = 0;
  Cycle offer;
};

struct PinRelay : sc_core::sc_module {
  PinRelay(sc_core::sc_module_name name, const Clock& c) : sc_module(name), clock(c) {
    SC_HAS_PROCESS(PinRelay);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
    SC_METHOD(set_ready);
    sensitive << out.valid << out.ready;
  }
  void set_ready() { in.ready.write(!out.valid.read() || out.ready.read()); }
  void edge() {
    if (in.valid.read() && in.ready.read()) {
      out.valid.write(true);
      out.word.write(in.word.read());
    } else if (out.ready.read()) {
      out.valid.write(false);
    }
  }
  PinIn<FrameWord> in;
  PinOut<FrameWord> out;
  const Clock& clock;
};

struct PinConsumer : sc_core::sc_module {
  PinConsumer(sc_core::sc_module_name name, const Clock& c, const Plan& p)
      : sc_module(name), clock(c), plan(p), next(p.pause[0]) {
    SC_HAS_PROCESS(PinConsumer);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
    in.ready.initialize(next == 0);
  }
  void edge() {
    const Cycle n = clock.cycle();
    if (in.valid.read() && in.ready.read()) {
      ++taken;
      next = taken < plan.pause.size() ? n + 1 + plan.pause[taken] : kClosed;
    }
    in.ready.write(n + 1 >= next);
  }
  PinIn<FrameWord> in;
  const Clock& clock;
  const Plan& plan;
  std::size_t taken = 0;
  Cycle next;
};

/// One case in one mix: bit 0 of `pins` is the producer, bit 1 the relay, bit 2 the consumer.
class Bench {
 public:
  Bench(const Plan& plan, unsigned pins, const Clock& clock) {
    for (int m = 0; m < 2; ++m) {
      const std::string name = m == 0 ? "first" : "second";
      links_.push_back(std::make_unique<Link<FrameWord>>(
          name, plan.depth[m], [&plan, m, name](const std::string& link, std::uint64_t word) {
            EXPECT_EQ(link, name);
            return plan.stall[m].at(word);
          }));
      links_.back()->set_probe([this, m](const FrameWord& word, Cycle pushed, Cycle taken) {
        history[m].push_back({word.frame, pushed, taken});
      });
    }
    PinOut<FrameWord>* out[2] = {};
    PinIn<FrameWord>* in[2] = {};
    if (pins & 1)
      out[0] = &make<PinProducer>(clock, plan).out;
    else
      make<TimedProducer>(plan, *links_[0]);
    if (pins & 2) {
      PinRelay& relay = make<PinRelay>(clock);
      in[0] = &relay.in;
      out[1] = &relay.out;
    } else {
      make<TimedRelay>(*links_[0], *links_[1]);
    }
    if (pins & 4)
      in[1] = &make<PinConsumer>(clock, plan).in;
    else
      make<TimedConsumer>(plan, *links_[1]);
    for (int m = 0; m < 2; ++m) {
      if (out[m] && in[m]) {
        auto& link = make<ClockedLink<FrameWord>>(clock, *links_[m]);
        bind(*out[m], link.in);
        bind(link.out, *in[m]);
      } else if (out[m]) {
        bind(*out[m], make<PinsToLink<FrameWord>>(clock, *links_[m]).in);
      } else if (in[m]) {
        bind(make<LinkToPins<FrameWord>>(clock, *links_[m]).out, *in[m]);
      }
    }
  }

  History history[2];

 private:
  template <class M, class... A>
  M& make(A&&... arguments) {
    auto module = std::make_unique<M>(sc_core::sc_gen_unique_name("part"), arguments...);
    M& made = *module;
    parts_.push_back(std::move(module));
    return made;
  }
  void bind(PinOut<FrameWord>& from, PinIn<FrameWord>& to) {
    wires_.push_back(std::make_unique<Wires<FrameWord>>(from, to));
  }

  std::vector<std::unique_ptr<Link<FrameWord>>> links_;
  std::vector<std::unique_ptr<Wires<FrameWord>>> wires_;
  std::vector<std::unique_ptr<sc_core::sc_module>> parts_;
};

TEST(Link, EveryMixOfTimedAndPinsHandsOverInTheSameCycles) {
  constexpr unsigned kCases = 150;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::vector<std::unique_ptr<Plan>> plans;
  std::vector<std::unique_ptr<Bench>> benches;
  for (unsigned seed = 0; seed < kCases; ++seed) {
    plans.push_back(std::make_unique<Plan>(seed));
    for (unsigned pins = 0; pins < 8; ++pins)
      benches.push_back(std::make_unique<Bench>(*plans.back(), pins, clock));
  }
  clock.start();
  sc_core::sc_start(60 * 110 * clock.period());
  clock.stop();
  for (unsigned seed = 0; seed < kCases; ++seed) {
    History expected[2];
    referee(*plans[seed], expected);
    for (unsigned pins = 0; pins < 8; ++pins) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", pins " + std::to_string(pins));
      for (int m = 0; m < 2; ++m)
        ASSERT_EQ(benches[seed * 8 + pins]->history[m], expected[m]) << "link " << m;
    }
  }
}

TEST(Clock, CountsCyclesOnRisingEdgesAndStopsWhenTold) {
  struct Counter : sc_core::sc_module {
    Counter(sc_core::sc_module_name name, Clock& c) : sc_module(name), clock(c) {
      SC_HAS_PROCESS(Counter);
      SC_METHOD(edge);
      dont_initialize();
      sensitive << clock.wire.posedge_event();
    }
    void edge() {
      EXPECT_EQ(clock.cycle(), seen);
      EXPECT_EQ(sc_core::sc_time_stamp(), static_cast<double>(seen + 1) * clock.period());
      if (++seen == 1000) clock.stop();
    }
    Clock& clock;
    Cycle seen = 0;
  };
  test::fresh_simulation();
  Clock clock("clock", 12.5);
  Counter counter("counter", clock);
  EXPECT_EQ(clock.cycle(), -1);
  clock.start();
  sc_core::sc_start();
  EXPECT_EQ(counter.seen, 1000);
}

}  // namespace
}  // namespace cigsim
