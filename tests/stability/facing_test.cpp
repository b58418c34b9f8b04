// SPDX-License-Identifier: MIT
// Faces that a format takes for turned away, or for edge on: those that it shows though it must
// not, and those that vanish.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/stability/catalogue.hpp"
#include "sim/stability/drawing.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"
#include "tests/support/ray_oracle.hpp"

namespace cigsim::stability {
namespace {

// Whether nothing is drawn that exact arithmetic turns away: half of the judgement.
bool shows_nothing_turned_away(const Triangle& t, const ViewTransform& view, const Format& format) {
  const Triangle both[2] = {t, {t[0], t[2], t[1]}};
  const int facing = exact_side(plane_of(t), view.eye);
  const Drawing drawing = draw(both, false, view, format);
  return std::all_of(drawing.faces.begin(), drawing.faces.end(), [&](const Drawing::Face& face) {
    return facing == (face.triangle == 0 ? 1 : -1);
  });
}

// Elements that show the triangle, seen from its front alone, by rays and as the format draws it.
struct Elements {
  std::size_t by_rays = 0, drawn = 0;
};
Elements elements(const Triangle& t, const ViewTransform& view, const Format& format) {
  const auto hits = test::cast_rays({{{t[0], t[1], t[2]}, 1, false}}, view);
  Elements out;
  out.by_rays = static_cast<std::size_t>(std::count(hits.begin(), hits.end(), 1));
  const Drawing drawing = draw({&t, 1}, false, view, format);
  for (int line = 0; line < view.raster.height; ++line) {
    const Drawing::Cover cover = drawing.cover(0, line);
    out.drawn += static_cast<std::size_t>(cover.end - cover.first);
  }
  return out;
}

struct Found {
  int vanished = 0, turned_away = 0, without_an_element = 0;
};
Found find(const Format& format, Axis axis, double value) {
  const Decision decision = facing_decision();
  Found found;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Extremes extremes = at(axis, value, random);
    const Instance instance = decision.pose({}, extremes, random);
    const Format both[2] = {format, format_named("exact")};
    const std::vector<Outcome> outcomes = decision.judge(instance, both);
    EXPECT_NE(outcomes[1].verdict, Verdict::kWrong);
    if (outcomes[0].verdict != Verdict::kWrong) continue;
    Triangle t = corners(instance);
    if (!shows_nothing_turned_away(t, instance.view, format)) {
      ++found.turned_away;
      continue;
    }
    ++found.vanished;
    if (exact_side(plane_of(t), instance.view.eye) < 0) std::swap(t[1], t[2]);
    const Elements shown = elements(t, instance.view, format);
    EXPECT_EQ(shown.drawn, 0u);
    found.without_an_element += shown.by_rays > 0;
  }
  return found;
}

// Planted: words of so few bits that the eyepoint, which stands on a wide floor, lies in its plane.
// Half of the picture shows the floor, and in the words it vanishes; nothing is shown that is
// turned away.
TEST(Facing, AFloorThatVanishesInNarrowWordsIsFound) {
  const Triangle floor{Vec3{-100, -100, 0}, Vec3{100, -100, 0}, Vec3{0, 100, 0}};
  Instance instance;
  add_corners(instance, floor);
  instance.view = {{0, 0, 0.002}, {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}, 24, {48, 48}};
  const Format narrow = format_named("machine:16,12,8,4");
  const Format formats[] = {narrow, format_named("machine"), format_named("double"),
                            format_named("exact")};
  const std::vector<Outcome> outcomes = facing_decision().judge(instance, formats);
  EXPECT_EQ(outcomes[0].verdict, Verdict::kWrong);
  EXPECT_LE(outcomes[0].error, outcomes[0].bound);
  for (std::size_t f = 1; f < outcomes.size(); ++f)
    EXPECT_EQ(outcomes[f].verdict, Verdict::kRight) << formats[f].name;
  EXPECT_TRUE(shows_nothing_turned_away(floor, instance.view, narrow));
  const Elements shown = elements(floor, instance.view, narrow);
  EXPECT_GT(shown.by_rays, 1000u);
  EXPECT_EQ(shown.drawn, 0u);
}

// Planted: float, whose product of normal and difference is zero near the plane.
TEST(Facing, AFaceThatVanishesInFloatIsFound) {
  const Found found = find(format_named("float"), Axis::kEdgeOn, 1e-15);
  EXPECT_GT(found.vanished, 10);
  EXPECT_GT(found.turned_away, 10);
}

TEST(Facing, AWideFaceIsNeitherLostNorTurnedRound) {
  for (const char* name : {"float", "double", "certified", "machine", "nasa1968"}) {
    const Found found = find(format_named(name), Axis::kScale, 1);
    EXPECT_EQ(found.vanished + found.turned_away, 0) << name;
  }
}

// What is lost for another reason is no answer about facing: a face that the eyepoint sees square,
// so far away that it lies between two lines.
TEST(Facing, AFaceBetweenTwoLinesIsNoQuestion) {
  const Decision decision = facing_decision();
  Random random(1);
  Instance instance = decision.pose({}, at(Axis::kDistance, 1e6, random), random);
  for (const Outcome& outcome : decision.judge(instance, usual_formats()))
    EXPECT_EQ(outcome.verdict, Verdict::kNone);
}

}  // namespace
}  // namespace cigsim::stability
