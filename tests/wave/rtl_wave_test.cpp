// SPDX-License-Identifier: MIT
// The RTL of a stage in the machine's wave: in every cycle its pins are those of the stage, its
// registers those of the clocked level, and nothing else changes.
#include <gtest/gtest.h>

#include <sstream>

#include "models/priority_resolver/clocked.hpp"
#include "models/priority_resolver/rtl.hpp"
#include "sim/wave/recorder.hpp"
#include "sim/wave/vcd_reader.hpp"
#include "tests/levels/resolver_case.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim {
namespace {

constexpr Cycle kCycles = 400;

/// A stage between links.
template <class Stage>
struct Bench {
  template <class... Library>
  Bench(const std::string& name, const test::ResolverCase& c, const Clock& clock,
        const Library&... library)
      : crossings("crossings", c.crossing_depth, c.waits),
        spans("spans", c.span_depth, c.waits),
        stage(name.c_str(), c.machine, clock, library..., {}) {
    parts.make<test::Feeder<CrossingWord>>(crossings.link, c.words, c.waits);
    parts.make<test::Drain<SpanWord>>(spans.link, c.waits);
    stage.clock(clock.wire);
    parts.connect(clock, crossings.link, stage.crossings);
    parts.connect(clock, stage.spans, spans.link);
  }
  test::RecordedLink<CrossingWord> crossings;
  test::RecordedLink<SpanWord> spans;
  Stage stage;
  test::Parts parts;
};

struct Recorded {
  std::string dump;
  test::History<SpanWord> spans;
};

Recorded recorded(const test::ResolverCase& c, bool wave, const CycleWindow& window) {
  test::fresh_simulation();
  const std::filesystem::path library =
      std::filesystem::path(CIGSIM_RTL_LIBRARIES) / "priority_resolver-Faces=64.so";
  std::ostringstream out;
  Clock clock("clock", 125);
  Bench<priority_resolver::Rtl> rtl("rtl_stage", c, clock, library);
  Bench<priority_resolver::Clocked> clocked("clocked_stage", c, clock);
  std::unique_ptr<Recorder> recorder;
  if (wave)
    recorder = std::make_unique<Recorder>("recorder", clock, "clock", out, window,
                                          [&](sc_core::sc_trace_file* file) {
                                            rtl.stage.trace(file);
                                            clocked.stage.trace(file);
                                          });
  clock.start();
  sc_core::sc_start(static_cast<double>(kCycles) * clock.period());
  clock.stop();
  if (recorder) recorder->finish();
  return {out.str(), rtl.spans.history};
}

class Dump {
 public:
  explicit Dump(const std::string& text)
      : reader_(
            [text, at = std::size_t{0}](char* block, std::size_t size) mutable {
              const std::size_t count = text.copy(block, size, at);
              at += count;
              return count;
            },
            "dump") {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < reader_.signals().size(); ++i) all.push_back(i);
    wave_ = reader_.read(all, {});
  }
  const Wave& wave() const { return wave_; }
  /// The changes, as numbers.
  std::vector<std::pair<WaveTime, std::uint64_t>> of(const std::string& name) const {
    std::vector<std::pair<WaveTime, std::uint64_t>> result;
    for (const WaveTrace& trace : wave_.traces)
      if (trace.signal.name == name) {
        for (const WaveChange& change : trace.changes) {
          std::uint64_t value = 0;
          for (const char digit : change.value) value = 2 * value + (digit == '1' ? 1 : 0);
          result.emplace_back(change.time, value);
        }
        return result;
      }
    ADD_FAILURE() << name;
    return result;
  }

 private:
  VcdReader reader_;
  Wave wave_;
};

TEST(RtlWave, ShowsThePinsOfTheStageAndTheRegistersOfTheClockedLevel) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const test::ResolverCase c(seed, 64);
    const Dump dump(recorded(c, true, {}).dump);
    for (const char* pin : {"crossings_valid", "crossings_ready", "spans_valid", "spans_ready"}) {
      SCOPED_TRACE(pin);
      const std::string name = pin;
      const bool input = name == "crossings_valid" || name == "spans_ready";
      const auto stage = dump.of("rtl_stage." + name);
      EXPECT_EQ(dump.of("rtl_stage.rtl." + name + (input ? "_i" : "_o")), stage);
      EXPECT_EQ(dump.of("clocked_stage." + name), stage);
    }
    EXPECT_EQ(dump.of("rtl_stage.rtl.crossings_element_i"),
              dump.of("rtl_stage.crossings_word.element"));
    EXPECT_EQ(dump.of("rtl_stage.rtl.at_q"), dump.of("clocked_stage.at"));
    EXPECT_EQ(dump.of("rtl_stage.rtl.start_q"), dump.of("clocked_stage.start"));
    EXPECT_EQ(dump.of("rtl_stage.rtl.active_set.clk_i"), dump.of("clock"));
  }
}

TEST(RtlWave, IsCutToTheWindow) {
  const test::ResolverCase c(3, 64);
  const Dump whole(recorded(c, true, {}).dump), window(recorded(c, true, {20, 59}).dump);
  EXPECT_EQ(window.wave().first, 20u * 1250);
  EXPECT_EQ(window.wave().last, 60u * 1250);
  const auto changes = window.of("rtl_stage.rtl.at_q");
  ASSERT_FALSE(changes.empty());
  std::vector<std::pair<WaveTime, std::uint64_t>> expected;
  for (const auto& [time, value] : whole.of("rtl_stage.rtl.at_q")) {
    if (time >= 60 * 1250) break;
    if (time <= 20 * 1250) expected.clear();
    expected.emplace_back(std::max<WaveTime>(time, 20 * 1250), value);
  }
  EXPECT_EQ(changes, expected);
}

TEST(RtlWave, ChangesNoResult) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const test::ResolverCase c(seed, 64);
    const Recorded plain = recorded(c, false, {}), waved = recorded(c, true, {10, 300});
    EXPECT_EQ(plain.spans, waved.spans);
    EXPECT_FALSE(plain.spans.empty());
  }
}

}  // namespace
}  // namespace cigsim
