// SPDX-License-Identifier: MIT
// Recording, held to what the reader finds in the file.
#include "sim/wave/recorder.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <sstream>

#include "sim/wave/vcd_reader.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim {
namespace {

using Changes = std::vector<WaveChange>;

// Counts cycles in a register and shows their lowest bit on a pin: both have the value n in
// cycle n. After cycle `last` the clock stands still, as when a run is over.
struct Counter : sc_core::sc_module {
  Counter(sc_core::sc_module_name name, Clock& clock, Cycle last)
      : sc_module(name), clock_(clock), last_(last) {
    SC_HAS_PROCESS(Counter);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
  }
  void edge() {
    ++count;
    low.write(count % 2 == 1);
    level = count * 0.5;
    if (clock_.cycle() == last_) clock_.stop();
  }
  void trace(sc_core::sc_trace_file* file) const {
    const std::string scope = std::string(name()) + ".";
    sc_core::sc_trace(file, count, scope + "state.count", 12);
    sc_trace(file, low.read(), scope + "low");
    sc_core::sc_trace(file, minus, scope + "minus");
    sc_core::sc_trace(file, level, scope + "level");
  }
  std::uint16_t count = 0;
  std::int32_t minus = -2;
  double level = 0;
  sc_core::sc_signal<bool> low{"low"};
  Clock& clock_;
  Cycle last_;
};

// The dump of a counter that runs to cycle `last`.
std::string record(const CycleWindow& window, Cycle last) {
  test::fresh_simulation();
  std::ostringstream out;
  Clock clock("clock", 125);
  Counter counter("counter", clock, last);
  Recorder recorder("recorder", clock, "clock", out, window,
                    [&](sc_core::sc_trace_file* file) { counter.trace(file); });
  clock.start();
  sc_core::sc_start();
  recorder.finish();
  return out.str();
}

Wave read(const std::string& text, std::vector<WaveSignal>& signals) {
  VcdReader reader(
      [text, at = std::size_t{0}](char* block, std::size_t size) mutable {
        const std::size_t count = text.copy(block, size, at);
        at += count;
        return count;
      },
      "dump");
  signals = reader.signals();
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < signals.size(); ++i) all.push_back(i);
  return reader.read(all, {});
}

std::string binary(unsigned value, int width) {
  std::string digits;
  for (int bit = width - 1; bit >= 0; --bit) digits += (value >> bit) & 1 ? '1' : '0';
  return digits;
}

// 125 ns are 1250 units of 100 ps.
TEST(Recorder, ARunFromItsFirstCycle) {
  std::vector<WaveSignal> signals;
  const Wave wave = read(record({}, 5), signals);
  EXPECT_EQ(signals, (std::vector<WaveSignal>{{"clock", "", 1, false},
                                              {"counter.low", "", 1, false},
                                              {"counter.minus", "[31:0]", 32, false},
                                              {"counter.level", "", 64, true},
                                              {"counter.state.count", "[11:0]", 12, false}}));
  EXPECT_DOUBLE_EQ(wave.unit_ns, 0.1);
  EXPECT_EQ(wave.first, 0u);
  Changes clock, low, count;
  for (unsigned n = 0; n <= 5; ++n) {
    clock.push_back({n * 1250, "1"});
    clock.push_back({n * 1250 + 625, "0"});
    low.push_back({n * 1250, n % 2 == 1 ? "1" : "0"});
    count.push_back({n * 1250, binary(n, 12)});
  }
  EXPECT_EQ(wave.traces[0].changes, clock);
  EXPECT_EQ(wave.traces[1].changes, low);
  EXPECT_EQ(wave.traces[2].changes, (Changes{{0, binary(0xfffffffe, 32)}}));
  EXPECT_EQ(wave.traces[3].changes.back(), (WaveChange{5 * 1250, "2.5"}));
  EXPECT_EQ(wave.traces[4].changes, count);
}

TEST(Recorder, AWindowHasItsCyclesAndNoOthers) {
  for (const CycleWindow window :
       {CycleWindow{0, 0}, CycleWindow{1, 1}, CycleWindow{2, 3}, CycleWindow{7, 11}}) {
    SCOPED_TRACE(window.first);
    std::vector<WaveSignal> signals;
    const Wave wave = read(record(window, 20), signals);
    EXPECT_EQ(wave.first, static_cast<WaveTime>(window.first) * 1250);
    EXPECT_EQ(wave.last, static_cast<WaveTime>(window.last + 1) * 1250);
    Changes count;
    for (Cycle n = window.first; n <= window.last; ++n)
      count.push_back({static_cast<WaveTime>(n) * 1250, binary(static_cast<unsigned>(n), 12)});
    EXPECT_EQ(wave.traces[4].changes, count);
  }
}

TEST(Recorder, ARunThatEndsEarlierLeavesAWholeFile) {
  std::vector<WaveSignal> signals;
  EXPECT_EQ(read(record({3, 100}, 5), signals).last, 6u * 1250);
  for (const Cycle first : {Cycle{50}, Cycle{1000000000000}}) {
    SCOPED_TRACE(first);
    EXPECT_EQ(read(record({first, first + 50}, 5), signals).traces[4].changes, Changes{});
  }
}

}  // namespace
}  // namespace cigsim
