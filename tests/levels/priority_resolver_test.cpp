// SPDX-License-Identifier: MIT
// Priority resolver: the functional level against each face painted on the line, and the timed and
// the clocked level against the functional one and against each other, cycle by cycle.
#include <gtest/gtest.h>

#include <tuple>

#include "models/priority_resolver/clocked.hpp"
#include "models/priority_resolver/functional.hpp"
#include "models/priority_resolver/timed.hpp"
#include "tests/levels/resolver_case.hpp"
#include "tests/support/fresh_simulation.hpp"
#include "tests/support/stage_bench.hpp"

namespace cigsim::priority_resolver {
namespace {

using Case = test::ResolverCase;

std::vector<Span> functional_spans(Functional& resolver, const std::vector<CrossingWord>& line,
                                   std::uint16_t width) {
  std::vector<Crossing> crossings;
  for (const CrossingWord& word : line)
    if (!word.end) crossings.push_back({word.face, word.element, word.left});
  std::vector<Span> spans;
  resolver.line(crossings, width, line.back().cut ? line.back().element : width,
                [&](const Span& span) { spans.push_back(span); });
  return spans;
}

/// What each element shows: of the faces from a left edge at or before it to a right edge after
/// it, or to the line's end, the one of highest priority; the background where the line is cut.
std::vector<std::uint32_t> painted(const std::vector<CrossingWord>& line, int width) {
  std::vector<std::uint32_t> shown(static_cast<std::size_t>(width), kNone);
  for (const CrossingWord& left : line) {
    if (left.end || !left.left) continue;
    int end = line.back().cut ? line.back().element : width;
    for (const CrossingWord& right : line)
      if (!right.end && !right.left && right.face == left.face)
        end = std::min<int>(end, right.element);
    for (int e = left.element; e < end; ++e)
      shown[static_cast<std::size_t>(e)] = std::min(shown[static_cast<std::size_t>(e)], left.face);
  }
  return shown;
}

class Bench {
 public:
  Bench(const Case& c, bool clocked, const Clock& clock)
      : crossings("crossings", c.crossing_depth, c.waits), spans("spans", c.span_depth, c.waits) {
    const auto report = [this](const Figures& frame) { figures.push_back(frame); };
    parts_.make<test::Feeder<CrossingWord>>(crossings.link, c.words, c.waits);
    parts_.make<test::Drain<SpanWord>>(spans.link, c.waits);
    if (clocked) {
      Clocked& stage = parts_.make<Clocked>(c.machine, clock, report);
      stage.clock(clock.wire);
      parts_.connect(clock, crossings.link, stage.crossings);
      parts_.connect(clock, stage.spans, spans.link);
    } else {
      parts_.make<Timed>(c.machine, Timed::Links{crossings.link, spans.link}, report);
    }
  }
  test::RecordedLink<CrossingWord> crossings;
  test::RecordedLink<SpanWord> spans;
  std::vector<Figures> figures;

 private:
  test::Parts parts_;
};

TEST(PriorityResolver, FunctionalSpansAreThoseOfFacesPaintedOnTheLine) {
  Functional resolver;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Case c(seed);
    for (const auto& line : c.lines) {
      std::vector<std::uint32_t> shown;
      std::uint32_t before = kNone - 1;
      for (const Span& span : functional_spans(resolver, line, c.width())) {
        ASSERT_EQ(span.first, shown.size());
        ASSERT_LT(span.first, span.end);
        ASSERT_NE(span.face, before);
        before = span.face;
        shown.resize(span.end, span.face);
      }
      ASSERT_EQ(shown, painted(line, c.machine.raster.width));
    }
  }
}

TEST(PriorityResolver, TimedAndClockedGiveTheFunctionalSpansInTheSameCycles) {
  constexpr unsigned kCases = 600;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::vector<std::unique_ptr<Case>> cases;
  std::vector<std::unique_ptr<Bench>> timed, clocked;
  for (unsigned seed = 0; seed < kCases; ++seed) {
    cases.push_back(std::make_unique<Case>(seed));
    timed.push_back(std::make_unique<Bench>(*cases.back(), false, clock));
    clocked.push_back(std::make_unique<Bench>(*cases.back(), true, clock));
  }
  test::run_timed_then_clocked(clock, [&] {
    Cycle last = 0;
    for (const auto& bench : timed) last = std::max(last, test::last_taken(bench->spans.history));
    return last;
  });

  Functional resolver;
  for (unsigned seed = 0; seed < kCases; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Case& c = *cases[seed];
    std::vector<SpanWord> expected;
    for (const auto& line : c.lines) {
      for (const Span& span : functional_spans(resolver, line, c.width()))
        expected.push_back({span.face, span.first, span.end, false});
      expected.back().last = true;
    }
    std::vector<SpanWord> spans;
    for (const auto& handover : timed[seed]->spans.history) spans.push_back(handover.word);
    ASSERT_EQ(spans, expected);
    ASSERT_EQ(clocked[seed]->crossings.history, timed[seed]->crossings.history);
    ASSERT_EQ(clocked[seed]->spans.history, timed[seed]->spans.history);
    ASSERT_EQ(timed[seed]->figures.size(), c.frames);
    ASSERT_TRUE(clocked[seed]->figures == timed[seed]->figures);
    std::uint64_t counted = 0;
    for (const Figures& frame : timed[seed]->figures) {
      counted += frame.spans;
      ASSERT_GE(frame.activity.idle, 0);
      ASSERT_GE(frame.activity.stalled, 0);
      ASSERT_GT(frame.activity.busy(), 0);
    }
    ASSERT_EQ(counted, expected.size());
  }
}

/// Where and when the spans of one line go into the link, at both levels.
std::vector<std::tuple<int, int, int, Cycle>> pushes(const Case& c) {
  test::fresh_simulation();
  std::vector<std::tuple<int, int, int, Cycle>> result[2];
  Clock clock("clock", 125);
  Bench timed(c, false, clock), clocked(c, true, clock);
  clock.start();
  sc_core::sc_start(200 * clock.period());
  for (const Bench* bench : {&timed, &clocked})
    for (const auto& [span, pushed, taken] : bench->spans.history)
      result[bench == &clocked].emplace_back(span.face == kNone ? -1 : static_cast<int>(span.face),
                                             span.first, span.end, pushed);
  EXPECT_EQ(result[0], result[1]);
  EXPECT_TRUE(timed.figures == clocked.figures);
  return result[0];
}

// Worked by hand from PR2 to PR6: words are taken in cycles 1 to 5, and the end word closes two
// spans.
TEST(PriorityResolver, SmallLineTakesTheCyclesWorkedByHand) {
  Case c;
  c.machine.raster = {8, 1};
  c.words = {{1, 1, true}, {0, 2, true}, {0, 5, false}, {1, 7, false}, {0, 0, false, true, false}};
  EXPECT_EQ(pushes(c),
            (std::vector<std::tuple<int, int, int, Cycle>>{
                {-1, 0, 1, 3}, {1, 1, 2, 4}, {0, 2, 5, 5}, {1, 5, 7, 6}, {-1, 7, 8, 7}}));
}

// The same, cut at element 4: face 0 up to there, and the background from there on.
TEST(PriorityResolver, CutLineTakesTheCyclesWorkedByHand) {
  Case c;
  c.machine.raster = {8, 1};
  c.words = {{1, 1, true}, {0, 2, true}, {0, 4, false, true, true}};
  EXPECT_EQ(pushes(c), (std::vector<std::tuple<int, int, int, Cycle>>{
                           {-1, 0, 1, 3}, {1, 1, 2, 4}, {0, 2, 4, 5}, {-1, 4, 8, 6}}));
}

}  // namespace
}  // namespace cigsim::priority_resolver
