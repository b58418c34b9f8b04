// SPDX-License-Identifier: MIT
// Priority resolver: the RTL against the clocked level, on every pin in every cycle.
#include <gtest/gtest.h>

#include "models/priority_resolver/clocked.hpp"
#include "models/priority_resolver/rtl.hpp"
#include "rtl/priority_resolver/priority_resolver.pins.hpp"
#include "tests/levels/resolver_case.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim::priority_resolver {
namespace {

using test::ResolverCase;

std::filesystem::path library(int faces) {
  return std::filesystem::path(CIGSIM_RTL_LIBRARIES) /
         ("priority_resolver-Faces=" + std::to_string(faces) + ".so");
}

/// The pins of a cycle.
struct Cut {
  bool crossings_valid, crossings_ready, spans_valid, spans_ready;
  CrossingWord crossing;
  SpanWord span;
  friend bool operator==(const Cut&, const Cut&) = default;
};
void PrintTo(const Cut& cut, std::ostream* out) {
  *out << "crossings " << cut.crossings_valid << cut.crossings_ready << " " << cut.crossing
       << "; spans " << cut.spans_valid << cut.spans_ready << " " << cut.span;
}

template <class Stage>
class PinRecorder : public sc_core::sc_module {
 public:
  PinRecorder(sc_core::sc_module_name name, const Clock& clock, const Stage& stage)
      : sc_module(name), stage_(stage) {
    SC_HAS_PROCESS(PinRecorder);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
  }
  std::vector<Cut> cuts;

 private:
  void edge() {
    cuts.push_back({stage_.crossings.valid, stage_.crossings.ready, stage_.spans.valid,
                    stage_.spans.ready, stage_.crossings.word, stage_.spans.word});
  }
  const Stage& stage_;
};

/// A stage between links with the stalls of a case.
template <class Stage>
class Bench {
 public:
  template <class... Library>
  Bench(const ResolverCase& c, const Clock& clock, Library... arguments)
      : crossings_("crossings", c.crossing_depth, c.waits), spans_("spans", c.span_depth, c.waits) {
    parts_.make<test::Feeder<CrossingWord>>(crossings_, c.words, c.waits);
    parts_.make<test::Drain<SpanWord>>(spans_, c.waits);
    const FiguresFunction report = [this](const Figures& frame) { figures.push_back(frame); };
    Stage* stage;
    if constexpr (std::is_same_v<Stage, Rtl>)
      stage = &rtl(c, clock, report, arguments...);
    else
      stage = &parts_.make<Stage>(c.machine, clock, report);
    stage->clock(clock.wire);
    parts_.connect(clock, crossings_, stage->crossings);
    parts_.connect(clock, stage->spans, spans_);
    recorder_ = &parts_.make<PinRecorder<Stage>>(clock, *stage);
  }
  const std::vector<Cut>& cuts() const { return recorder_->cuts; }
  std::vector<Figures> figures;

 private:
  Rtl& rtl(const ResolverCase& c, const Clock& clock, const FiguresFunction& report,
           const std::filesystem::path& library, std::uint32_t seed) {
    return parts_.make<Rtl>(c.machine, clock, library, report, seed);
  }
  Link<CrossingWord> crossings_;
  Link<SpanWord> spans_;
  test::Parts parts_;
  PinRecorder<Stage>* recorder_;
};

/// Half of the cases have faces with a left and a right edge; in the others faces have any edges,
/// so that inside states meet their ends (PR1).
std::unique_ptr<ResolverCase> make_case(unsigned seed, int faces) {
  auto made = std::make_unique<ResolverCase>(seed, static_cast<std::uint32_t>(faces));
  if (seed % 8 < 2) {  // as wide a raster as there is
    const int factor = 16383 / made->machine.raster.width;
    made->machine.raster.width *= factor;
    for (CrossingWord& word : made->words)
      word.element = static_cast<decltype(word.element)>(word.element * factor);
  }
  if (seed % 2 == 0) return made;
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  // 3 of all faces, or 16 of a word of the active set, so that many of its bits are set.
  std::uint32_t few[16];
  const std::size_t count = seed % 4 == 1 ? 3 : 16;
  const std::uint32_t group = 32 * below(static_cast<std::size_t>(faces) / 32);
  for (std::uint32_t i = 0; i < 16; ++i)
    few[i] = count == 3 ? below(faces) : group + 2 * i + below(2);
  for (CrossingWord& word : made->words) {
    if (word.end) continue;
    word.face = few[below(count)];
    word.left = below(2) == 0;
  }
  return made;
}

void lock_step(int faces, unsigned first_seed, unsigned cases) {
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::vector<std::unique_ptr<ResolverCase>> made;
  std::vector<std::unique_ptr<Bench<Clocked>>> clocked;
  std::vector<std::unique_ptr<Bench<Rtl>>> rtl;
  for (unsigned i = 0; i < cases; ++i) {
    const unsigned seed = first_seed + i;
    made.push_back(make_case(seed, faces));
    clocked.push_back(std::make_unique<Bench<Clocked>>(*made.back(), clock));
    rtl.push_back(std::make_unique<Bench<Rtl>>(*made.back(), clock, library(faces), seed + 1));
  }
  const auto running = [&] {
    for (unsigned i = 0; i < cases; ++i)
      if (clocked[i]->figures.size() < made[i]->frames) return true;
    return false;
  };
  clock.start();
  for (int hundreds = 0; running() && hundreds < 1000; ++hundreds)
    sc_core::sc_start(100 * clock.period());
  sc_core::sc_start(10 * clock.period());
  clock.stop();

  for (unsigned i = 0; i < cases; ++i) {
    SCOPED_TRACE("seed " + std::to_string(first_seed + i));
    ASSERT_EQ(clocked[i]->figures.size(), made[i]->frames);
    ASSERT_EQ(rtl[i]->cuts().size(), clocked[i]->cuts().size());
    for (std::size_t cycle = 0; cycle < clocked[i]->cuts().size(); ++cycle)
      ASSERT_EQ(rtl[i]->cuts()[cycle], clocked[i]->cuts()[cycle]) << "in cycle " << cycle;
    ASSERT_TRUE(rtl[i]->figures == clocked[i]->figures);
  }
}

TEST(PriorityResolverRtl, EveryPinAgreesWithClockedInEveryCycleOf64Faces) {
  lock_step(64, 0, test::cases(600));
}
TEST(PriorityResolverRtl, EveryPinAgreesWithClockedInEveryCycleOf1024Faces) {
  lock_step(1024, 1000, test::cases(300));
}
TEST(PriorityResolverRtl, EveryPinAgreesWithClockedInEveryCycleOf4096Faces) {
  lock_step(4096, 2000, test::cases(150));
}

// Faces of all words of the active set, one after the other.
TEST(PriorityResolverRtl, FacesOfAllWordsAgree) {
  for (const int faces : {64, 1024, 4096}) {
    test::fresh_simulation();
    const auto words = static_cast<std::uint32_t>(faces) / 32;
    ResolverCase c;
    c.machine.raster = {static_cast<int>(words) + 2, 1};
    for (std::uint32_t w = 0; w < words; ++w) {
      const auto element = static_cast<std::uint16_t>(w);
      c.words.push_back({32 * w + w % 32, element, true});
      c.words.push_back({32 * w + w % 32, static_cast<std::uint16_t>(element + 1), false});
    }
    c.words.push_back({0, 0, false, true, false});
    Clock clock("clock", 125);
    Bench<Clocked> clocked(c, clock);
    Bench<Rtl> rtl(c, clock, library(faces), 1u);
    clock.start();
    sc_core::sc_start(1000 * clock.period());
    clock.stop();
    ASSERT_EQ(clocked.figures.size(), 1u);
    ASSERT_EQ(rtl.cuts(), clocked.cuts());
    ASSERT_TRUE(rtl.figures == clocked.figures);
  }
}

/// What ends a simulation of these words.
std::string fault(const std::vector<CrossingWord>& words) {
  test::fresh_simulation();
  ResolverCase c;
  c.machine.raster = {8, 1};
  c.words = words;
  Clock clock("clock", 125);
  Bench<Rtl> bench(c, clock, library(64), 1u);
  clock.start();
  try {
    sc_core::sc_start(100 * clock.period());
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(PriorityResolverRtl, FaceBeyondTheSizeIsNamed) {
  EXPECT_EQ(fault({{63, 1, true}, {63, 2, false}, {0, 0, false, true, false}}), "");
  EXPECT_NE(fault({{64, 1, true}, {64, 2, false}, {0, 0, false, true, false}})
                .find("priority_resolver: face 64: the picture has more faces than this RTL size"),
            std::string::npos);
  for (int bit = 6; bit < 32; ++bit)
    EXPECT_NE(fault({{1u << bit, 1, true}, {0, 0, false, true, false}}).find("more faces"),
              std::string::npos)
        << bit;
}

TEST(PriorityResolverRtl, BrokenContractsEndTheSimulation) {
  const auto broken = [](const std::vector<CrossingWord>& words) {
    return fault(words).find("a contract of the RTL is broken") != std::string::npos;
  };
  EXPECT_FALSE(broken({{0, 5, true}, {0, 5, false, true, true}}));
  EXPECT_TRUE(broken({{0, 5, true}, {0, 4, false}, {0, 0, false, true, false}}));
  EXPECT_TRUE(broken({{0, 9, true}, {0, 0, false, true, false}}));
  EXPECT_TRUE(broken({{0, 5, true}, {0, 4, false, true, true}}));
}

}  // namespace
}  // namespace cigsim::priority_resolver
