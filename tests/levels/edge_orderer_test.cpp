// SPDX-License-Identifier: MIT
// Edge orderer: the functional level on machine words against brute force; the timed and the
// clocked level against that, and against each other, cycle by cycle.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "models/edge_orderer/clocked.hpp"
#include "models/edge_orderer/functional.hpp"
#include "models/edge_orderer/timed.hpp"
#include "tests/levels/orderer_case.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim::edge_orderer {
namespace {

using Case = test::OrdererCase;
using test::upright_edges;

constexpr Word kOne = test::kOneElement;

struct Line {
  std::vector<CrossingWord> words;  ///< with the end word
  std::size_t crossings = 0;
};

/// EO1 to EO4 read literally.
std::vector<Line> brute_force(const Case& c, const std::vector<EdgeWord>& edges, Figures& figures) {
  figures = {};
  figures.edges = edges.size();
  std::vector<Line> lines;
  for (int r = 0; r < c.machine.raster.height; ++r) {
    std::vector<std::tuple<std::uint16_t, bool, std::uint32_t>> all;
    for (const EdgeWord& edge : edges) {
      if (r < edge.first_line || r >= edge.end_line) continue;
      double x = edge.x;  // exact: whole numbers below 2^53
      for (int line = edge.first_line; line < r; ++line) {
        x += edge.slope;
        const bool over = x > 2147483647.0 || x < -2147483648.0;
        if (over) x = x > 0 ? 2147483647.0 : -2147483648.0;
        figures.overflows += over && line + 1 == r;
      }
      const double element =
          std::min(std::max(std::ceil(x / kOne), 0.0), static_cast<double>(c.machine.raster.width));
      all.emplace_back(static_cast<std::uint16_t>(element), edge.left, edge.face);
    }
    std::sort(all.begin(), all.end());
    const std::size_t n = all.size(), capacity = c.machine.crossing_capacity;
    figures.crossings += n;
    ++figures.passes;
    if (n > figures.worst_line_crossings) {
      figures.worst_line = static_cast<std::uint32_t>(r);
      figures.worst_line_crossings = static_cast<std::uint32_t>(n);
    }
    CrossingWord end{0, 0, false, true, false};
    std::uint32_t limit = kNone;
    if (capacity > 0 && n > capacity) {
      ++figures.overfull_lines;
      if (c.policy == OverloadPolicy::kCut) {
        end.cut = true;
        end.element = std::get<0>(all[capacity]);
        all.resize(capacity);
      } else if (c.policy == OverloadPolicy::kDrop) {
        std::size_t up_to_limit = 0;
        for (limit = 0;; ++limit) {
          for (const auto& crossing : all) up_to_limit += std::get<2>(crossing) == limit;
          if (up_to_limit > capacity) break;
        }
      } else {
        for (std::size_t left = n; left > capacity; left -= capacity) ++figures.passes;
      }
    }
    Line line;
    line.crossings = n;
    for (const auto& [element, left, face] : all)
      if (face < limit) line.words.push_back({face, element, left, false, false});
    figures.dropped += n - line.words.size();
    line.words.push_back(end);
    lines.push_back(line);
  }
  return lines;
}

std::vector<CrossingWord> words_of(const std::vector<Line>& lines) {
  std::vector<CrossingWord> words;
  for (const Line& line : lines) words.insert(words.end(), line.words.begin(), line.words.end());
  return words;
}

EdgeList<MachineWord> edge_list(const std::vector<EdgeWord>& words) {
  EdgeList<MachineWord> list;
  for (const EdgeWord& word : words) {
    while (list.faces.size() <= word.face) {
      list.faces.emplace_back();
      list.faces.back().first_edge = static_cast<std::uint32_t>(list.edges.size());
    }
    ++list.faces.back().edge_count;
    list.edges.push_back({word.first_line, word.end_line, word.left, {word.x}, {word.slope}});
  }
  return list;
}

TEST(EdgeOrdererOnMachineWords, IsWhatTheRulesSay) {
  for (unsigned seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Case c(seed);
    Functional<MachineWord> orderer(c.machine.crossing_capacity, c.policy);
    for (const auto& edges : c.frames) {
      Figures expected;
      const std::vector<Line> lines = brute_force(c, edges, expected);
      OrderedCrossings got;
      ASSERT_EQ(orderer.compute(edge_list(edges), c.machine.raster, got), expected);
      std::vector<CrossingWord> words;
      for (std::size_t r = 0; r < lines.size(); ++r) {
        for (std::uint32_t i = got.first[r]; i < got.first[r + 1]; ++i) {
          const Crossing& crossing = got.crossings[i];
          words.push_back({crossing.face, crossing.element, crossing.left, false, false});
        }
        const CrossingWord& end = lines[r].words.back();
        words.push_back(end);
        ASSERT_EQ(got.limit[r], end.cut ? end.element : c.machine.raster.width) << "line " << r;
      }
      ASSERT_EQ(words, words_of(lines));
    }
  }
}

// EO2, EO3: 5/4 rounds up to 2, 2 stays, below 0 and beyond the raster are clamped.
TEST(EdgeOrdererOnMachineWords, ElementIsTheSmallestWholeNumberNotBelowTheCrossing) {
  EdgeList<MachineWord> list;
  list.faces.resize(1);
  list.faces[0].edge_count = 5;
  for (const Word x : {kOne + kOne / 4, 2 * kOne, 2 * kOne + 1, -kOne, 9 * kOne})
    list.edges.push_back({0, 1, true, {x}, {0}});
  OrderedCrossings got;
  Functional<MachineWord>().compute(list, {8, 1}, got);
  std::vector<int> elements;
  for (const Crossing& crossing : got.crossings) elements.push_back(crossing.element);
  EXPECT_EQ(elements, (std::vector<int>{0, 2, 2, 3, 8}));
}

/// The stage at one level, with all that happened on its links.
struct Bench {
  Bench(const Case& c, const Clock* clock)
      : edges("edges", c.depths[0], c.waits),
        loaded("loaded", c.depths[1], c.waits),
        start("start", c.depths[2], c.waits),
        crossings("crossings", c.depths[3], c.waits) {
    parts.make<test::OrdererSequencer>(c, edges.link, loaded.link, start.link, crossings.link);
    const auto report = [this](const Figures& f) { figures.push_back(f); };
    if (clock == nullptr) {
      parts.make<Timed>(c.machine, c.policy,
                        Timed::Links{edges.link, loaded.link, start.link, crossings.link}, report);
      return;
    }
    auto& stage = parts.make<Clocked>(c.machine, c.policy, *clock, report);
    stage.clock(clock->wire);
    parts.connect(*clock, edges.link, stage.edges);
    parts.connect(*clock, stage.loaded, loaded.link);
    parts.connect(*clock, start.link, stage.start);
    parts.connect(*clock, stage.crossings, crossings.link);
  }

  test::RecordedLink<EdgeWord> edges;
  test::RecordedLink<FrameWord> loaded, start;
  test::RecordedLink<CrossingWord> crossings;
  std::vector<Figures> figures;
  test::Parts parts;
};

TEST(EdgeOrdererLevels, AgreeToTheCycleAndWithBruteForce) {
  constexpr unsigned kCases = 1500;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::vector<std::unique_ptr<Case>> cases;
  std::vector<std::unique_ptr<Bench>> timed, clocked;
  for (unsigned seed = 0; seed < kCases; ++seed) {
    cases.push_back(std::make_unique<Case>(seed));
    timed.push_back(std::make_unique<Bench>(*cases.back(), nullptr));
    clocked.push_back(std::make_unique<Bench>(*cases.back(), &clock));
  }
  clock.start();
  sc_core::sc_start(30000 * clock.period());
  clock.stop();
  for (unsigned seed = 0; seed < kCases; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Case& c = *cases[seed];
    const Bench &t = *timed[seed], &k = *clocked[seed];
    std::vector<CrossingWord> expected, got;
    for (const auto& edges : c.frames) {
      Figures unused;
      for (const CrossingWord& word : words_of(brute_force(c, edges, unused)))
        expected.push_back(word);
    }
    for (const auto& handover : t.crossings.history) got.push_back(handover.word);
    ASSERT_EQ(got, expected);
    ASSERT_EQ(k.edges.history, t.edges.history);
    ASSERT_EQ(k.loaded.history, t.loaded.history);
    ASSERT_EQ(k.start.history, t.start.history);
    ASSERT_EQ(k.crossings.history, t.crossings.history);
    ASSERT_EQ(t.figures.size(), c.frames.size());
    ASSERT_EQ(k.figures.size(), c.frames.size());
    for (std::size_t f = 0; f < c.frames.size(); ++f) {
      Figures rules;
      brute_force(c, c.frames[f], rules);
      rules.frame = static_cast<std::uint32_t>(f);
      rules.activity = t.figures[f].activity;
      ASSERT_EQ(t.figures[f], rules);
      ASSERT_EQ(k.figures[f], rules)
          << "stalled " << k.figures[f].activity.stalled << " for " << rules.activity.stalled;
    }
  }
}

/// Cycles from the start word's taking to the pushes of the words, both levels alike.
std::vector<Cycle> pushes(const Case& c) {
  test::fresh_simulation();
  std::vector<Cycle> result[2];
  Clock clock("clock", 125);
  Bench timed(c, nullptr), clocked(c, &clock);
  clock.start();
  sc_core::sc_start(10000 * clock.period());
  for (const Bench* bench : {&timed, &clocked})
    for (const auto& handover : bench->crossings.history)
      result[bench == &clocked].push_back(handover.pushed - bench->start.history.at(0).taken);
  EXPECT_EQ(result[0], result[1]);
  return result[0];
}

// Worked by hand from EO8 to EO12: two crossings a line, so B = 1, 4, 7 and F = 3, 6, 9.
TEST(EdgeOrdererLevels, SmallRasterTakesTheCyclesWorkedByHand) {
  EXPECT_EQ(pushes(upright_edges(2, 3, 0, OverloadPolicy::kDrop)),
            (std::vector<Cycle>{4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

// Five crossings in passes of two: B = 1, 7, 13 and F = 6, 12, 18.
TEST(EdgeOrdererLevels, ExtendedLineTakesTheCyclesWorkedByHand) {
  EXPECT_EQ(pushes(upright_edges(5, 1, 2, OverloadPolicy::kExtend)),
            (std::vector<Cycle>{7, 8, 13, 14, 19, 20}));
}

TEST(EdgeOrdererLevels, FullLineTakesLessThanTheCyclesOfARasterLine) {
  const std::vector<Cycle> at = pushes(upright_edges(256, 8, 256, OverloadPolicy::kDrop));
  ASSERT_EQ(at.size(), 8u * 257);
  for (std::size_t line = 1; line < 8; ++line)
    EXPECT_EQ(at[line * 257 + 256] - at[line * 257 - 1], 257);
}

}  // namespace
}  // namespace cigsim::edge_orderer
