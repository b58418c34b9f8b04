// SPDX-License-Identifier: MIT
// The decisions at their extremes. What claims never to be wrong must not be, and what is planted
// to be wrong must be found.
#include <gtest/gtest.h>

#include <algorithm>

#include "models/database/prepare.hpp"
#include "models/environment/read.hpp"
#include "sim/stability/catalogue.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"
#include "sim/stability/sweep.hpp"

namespace cigsim::stability {
namespace {

std::vector<Format> formats(std::initializer_list<const char*> names) {
  std::vector<Format> out;
  for (const char* name : names) out.push_back(format_named(name));
  return out;
}

SweepPlan plan(std::vector<Decision> decisions, std::vector<Format> formats, std::uint32_t trials) {
  SweepPlan out;
  out.decisions = std::move(decisions);
  out.formats = std::move(formats);
  out.axes.assign(kAxes.begin(), kAxes.end());
  out.trials = trials;
  return out;
}

// Every cell of the sweep, in words where something is wrong.
void expect_none_wrong(const SweepPlan& plan, const Sweep& sweep) {
  for (const Cell& cell : sweep.cells) {
    SCOPED_TRACE(testing::Message()
                 << plan.decisions[cell.decision].name << " in " << plan.formats[cell.format].name
                 << ", " << name_of(cell.axis) << " " << cell.value << ", seed " << plan.seed);
    EXPECT_EQ(cell.wrong, 0u);
    EXPECT_EQ(cell.broken, 0u);
  }
}

TEST(Decisions, ExactAndCertifiedAreNeverWrong) {
  const SweepPlan p = plan(decisions(), formats({"exact", "certified"}), 3);
  expect_none_wrong(p, sweep(p, {}));
}

TEST(Decisions, DoublesAreNeverWrongAboutSidesAndOrder) {
  const SweepPlan p =
      plan({side_decision(), listability_decision(), facing_decision()}, formats({"double"}), 25);
  expect_none_wrong(p, sweep(p, {}));
}

TEST(Decisions, DoublesKeepEdgesToAThousandthOfAnElement) {
  const SweepPlan p =
      plan({pyramid_decision(), projection_decision(), edge_decision()}, formats({"double"}), 6);
  const Sweep s = sweep(p, {});
  for (std::size_t d = 0; d < p.decisions.size(); ++d) {
    const Summary found = summary(s, d, 0);
    EXPECT_EQ(found.broken, 0u) << p.decisions[d].name;
    EXPECT_GT(found.claims, 0u) << p.decisions[d].name;
  }
}

void expect_bounds_held(const SweepPlan& plan) {
  const Sweep s = sweep(plan, {});
  for (std::size_t d = 0; d < plan.decisions.size(); ++d)
    for (std::size_t f = 0; f < plan.formats.size(); ++f) {
      const Summary found = summary(s, d, f);
      EXPECT_EQ(found.broken, 0u) << plan.decisions[d].name << " in " << plan.formats[f].name;
      EXPECT_GT(found.claims, 0u) << plan.decisions[d].name << " in " << plan.formats[f].name;
    }
}

TEST(Decisions, WordsKeepTheBoundsThatFollowFromTheirWidths) {
  const std::vector<Format> words =
      formats({"machine", "nasa1968", "machine:24,16,12,8", "machine:20,16,12,8"});
  expect_bounds_held(plan(
      {side_decision(), listability_decision(), facing_decision(), hither_decision()}, words, 30));
  expect_bounds_held(plan({pyramid_decision(), projection_decision(), edge_decision()}, words, 4));
}

TEST(Decisions, SharedOnesAreNeverWrong) {
  const SweepPlan p =
      plan({convexity_decision(), hull_decision(), sphere_decision(), retrieval_decision()},
           formats({"double"}), 15);
  expect_none_wrong(p, sweep(p, {}));
}

// Lengths below the normal numbers, where products of a plane's normal and a distance underflow.
TEST(Decisions, RetrievalKeepsSpheresOfSubnormalSize) {
  Instance touching;
  touching.spheres = {
      {{2.25965340662233e-310, -9.37106740192e-312, -2.538466428355e-312}, 9.286437499201e-311}};
  touching.view = {{1.0569913925907e-310, -7.6908078868793e-311, 3.4746109849727e-311},
                   {{{-0.21460444010647217, 0.9395009337355882, -0.2669886323358083},
                     {-0.9700981824292653, -0.17330323137505577, 0.16992794485428134},
                     {-0.11337747013416459, -0.29547247842213953, -0.9485997911453781}}},
                   41.569219381653056,
                   {48, 48}};
  const std::vector<Format> format = formats({"double"});
  EXPECT_EQ(retrieval_decision().judge(touching, format)[0].verdict, Verdict::kRight);
}

// Planted: float is told to be exact.
TEST(Decisions, AFloatNearAPlaneFlipsSides) {
  SweepPlan p = plan({side_decision()}, formats({"float"}), 20);
  p.axes = {Axis::kNear};
  const Sweep s = sweep(p, {});
  const Summary found = summary(s, 0, 0);
  ASSERT_NE(found.worst, nullptr);
  EXPECT_GT(found.worst_share(), 0.3);
  const Cell* first = first_failure(s, 0, 0, Axis::kNear);
  ASSERT_NE(first, nullptr);
  // A float has 2^29 doubles for each of its steps: far beyond that it is right again.
  EXPECT_GT(first->value, 1e4);
  EXPECT_LT(first->value, 1e12);
  for (const Cell& cell : s.cells)
    if (cell.value == 1e12) {
      EXPECT_EQ(cell.wrong, 0u);
    }
}

// Planted: words with few bits.
TEST(Decisions, NarrowWordsAreFound) {
  SweepPlan p = plan({edge_decision()}, formats({"machine:16,12,8,4", "machine"}), 20);
  p.axes = {Axis::kScale};
  const Sweep s = sweep(p, {});
  EXPECT_GT(summary(s, 0, 0).wrong, summary(s, 0, 0).posed / 4);
  EXPECT_LT(summary(s, 0, 1).wrong, summary(s, 0, 1).posed / 20);
}

// Planted: a side test in doubles from a normal of three points, without an error bound.
std::vector<Outcome> judge_without_bound(const Instance& instance,
                                         std::span<const Format> formats) {
  const Plane plane = make_plane(instance.planes[0]);
  const double value = dot(plane.normal, instance.view.eye - plane.exact.p);
  const int truth = exact_side(instance.planes[0], instance.view.eye);
  const bool right = (value >= 0) == (truth >= 0);
  return in_each(formats, [&](const Format&) {
    return answer(right, distance_from(instance.planes[0], instance.view.eye), 0);
  });
}

TEST(Decisions, AFilterWithoutItsBoundIsFound) {
  SweepPlan p = plan({side_decision()}, formats({"double"}), 40);
  p.decisions[0].judge = judge_without_bound;
  const Sweep s = sweep(p, {});
  EXPECT_GT(summary(s, 0, 0, Axis::kNear).wrong, 20u);
  EXPECT_GT(summary(s, 0, 0, Axis::kNear).broken, 20u);
  EXPECT_GT(summary(s, 0, 0, Axis::kSliver).wrong, 0u);
  EXPECT_EQ(summary(s, 0, 0, Axis::kScale).wrong, 0u);
}

// Planted: a decision that is not taken at all is not taken for right.
TEST(Decisions, WhatAFormatDoesNotDecideIsNotCounted) {
  SweepPlan p = plan({hither_decision()}, formats({"double", "machine"}), 4);
  const Sweep s = sweep(p, {});
  EXPECT_EQ(summary(s, 0, 0).posed, 0u);
  EXPECT_GT(summary(s, 0, 1).posed, 0u);
}

TEST(Decisions, AFailureCanBePosedAgain) {
  SweepPlan p = plan({side_decision()}, formats({"float", "nasa1968"}), 10);
  p.axes = {Axis::kNear, Axis::kMixed};
  int failures = 0;
  for (const Cell& cell : sweep(p, {}).cells) {
    if (!cell.first) continue;
    ++failures;
    Random random(cell.first->seed);
    const Extremes extremes = at(cell.axis, cell.value, random);
    const Instance again = p.decisions[0].pose({}, extremes, random);
    EXPECT_EQ(again.planes, cell.first->instance.planes);
    EXPECT_EQ(again.view.eye, cell.first->instance.view.eye);
    EXPECT_EQ(p.decisions[0].judge(again, p.formats)[cell.format].verdict, Verdict::kWrong);
  }
  EXPECT_GT(failures, 5);
}

TEST(Decisions, TheSameSeedGivesTheSameSweep) {
  SweepPlan p = plan({side_decision(), projection_decision()}, formats({"float", "machine"}), 4);
  const Sweep one = sweep(p, {}), two = sweep(p, {});
  ASSERT_EQ(one.cells.size(), two.cells.size());
  for (std::size_t i = 0; i < one.cells.size(); ++i) {
    EXPECT_EQ(one.cells[i].wrong, two.cells[i].wrong);
    EXPECT_EQ(one.cells[i].worst_error, two.cells[i].worst_error);
  }
  p.seed = 2;
  const Sweep other = sweep(p, {});
  EXPECT_TRUE(std::any_of(one.cells.begin(), one.cells.end(), [&](const Cell& cell) {
    return cell.worst_error !=
           other.cells[static_cast<std::size_t>(&cell - one.cells.data())].worst_error;
  }));
}

TEST(Decisions, ASceneIsAskedAboutItsOwnThings) {
  const Material scene =
      material_of(prepare(read_environment(CIGSIM_SOURCE_DIR "/scenes/airfield.json").environment));
  EXPECT_GT(scene.triangles.size(), 100u);
  EXPECT_GT(scene.planes.size(), 10u);
  EXPECT_GT(scene.bodies.size(), 10u);
  const SweepPlan p = plan(decisions(), formats({"exact"}), 1);
  expect_none_wrong(p, sweep(p, scene));
}

TEST(Decisions, ValuesHoldTheBenignOne) {
  for (const Axis axis :
       {Axis::kScale, Axis::kOffset, Axis::kFov, Axis::kDistance, Axis::kSliver}) {
    const std::vector<double>& values = values_of(axis);
    EXPECT_TRUE(std::any_of(values.begin(), values.end(), [&](double value) {
      return std::abs(extremity(axis, value)) < 1e-12 || (axis == Axis::kSliver && value == 1);
    })) << name_of(axis);
  }
  EXPECT_LT(extremity(Axis::kNear, 100), extremity(Axis::kNear, 1));
  EXPECT_LT(extremity(Axis::kScale, 10), extremity(Axis::kScale, 1e-3));
}

TEST(Decisions, FormatsAreReadStrictly) {
  const Format words = format_named("machine:24,22,16,12");
  EXPECT_EQ(words.machine.formats, (WordFormats{24, 22, 16, 12}));
  for (const char* name :
       {"machine:24,22,16", "machine:24,22,15,12", "machine:99,22,16,12", "machine:", "flaot", ""})
    EXPECT_ANY_THROW(format_named(name)) << name;
}

}  // namespace
}  // namespace cigsim::stability
