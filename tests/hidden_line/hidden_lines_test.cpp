// SPDX-License-Identifier: MIT
#include "models/hidden_line/hidden_lines.hpp"

#include <gtest/gtest.h>

#include "models/environment/placement.hpp"
#include "models/environment/shapes.hpp"
#include "tests/hidden_line/oracle.hpp"

namespace cigsim::test {
namespace {

using hidden_line::Counters;
using hidden_line::HiddenLines;
using hidden_line::PartSet;
using hidden_line::Piece;
using hidden_line::solid_part;
using hidden_line::wire_part;

Environment levine(const std::string& set) {
  return read_environment(std::string(CIGSIM_SOURCE_DIR) + "/scenes/levine-" + set + ".json")
      .environment;
}

// The middle of what stands there, and its reach.
std::pair<Vec3, double> extent(const Environment& environment) {
  Vec3 low = environment.objects[0].vertices[0], high = low;
  for (const Object& object : environment.objects)
    for (const Vec3& v : object.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  const Vec3 d = high - low;
  return {low * 0.5 + high * 0.5, std::sqrt(dot(d, d)) / 2};
}

void check(HiddenLines& lines, const ViewTransform& view, SampleCounts& counts) {
  lines.compute(view, true);
  EXPECT_EQ(check_pieces(lines, view, 1, counts), "");
  EXPECT_EQ(check_invisibility(lines, view), "");
  const Counters& c = lines.counters();
  EXPECT_LE(c.objects_in_window, c.objects_considered);
  EXPECT_LE(c.intersections_computed, c.edges_considered);
  EXPECT_LE(c.actual_intersections, c.intersections_computed);
  EXPECT_LE(c.objects_in_window_inv, c.objects_considered_inv);
  EXPECT_LE(c.intersections_computed_inv, c.edges_considered_inv);
}

class LevineSets : public ::testing::TestWithParam<const char*> {};

// All of a data set in view, the eye going round it (yaw) and over it (pitch).
TEST_P(LevineSets, YawAndPitch) {
  const Environment environment = levine(GetParam());
  HiddenLines lines(parts_of(environment));
  EXPECT_EQ(lines.sepl().unresolved_pairs(), 0u);
  const auto [centre, reach] = extent(environment);
  SampleCounts counts;
  for (const int degrees : {0, 52, 187}) {
    for (const bool pitch : {false, true}) {
      SCOPED_TRACE(std::string(pitch ? "pitch " : "yaw ") + std::to_string(degrees));
      const double s = 3 * reach * sin_degrees(degrees), c = 3 * reach * cos_degrees(degrees);
      const Vec3 eye = centre + (pitch ? Vec3{0, -c, s} : Vec3{s, -c, 0});
      check(lines, view_from(eye, centre), counts);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(counts.hidden, 0u);
}

INSTANTIATE_TEST_SUITE_P(Levine, LevineSets,
                         ::testing::Values("cubes-4", "cubes-8", "cubes-16", "city"));

// The larger data sets once, from an odd place.
class LargeLevineSets : public ::testing::TestWithParam<const char*> {};
TEST_P(LargeLevineSets, OneView) {
  const Environment environment = levine(GetParam());
  HiddenLines lines(parts_of(environment));
  const auto [centre, reach] = extent(environment);
  SampleCounts counts;
  const ViewTransform view = view_from(centre + Vec3{1.3, -2.2, 1.1} * reach, centre);
  lines.compute(view, true);
  EXPECT_EQ(check_pieces(lines, view, 1, counts), "");
  EXPECT_GT(lines.counters().actual_intersections, 0u);
}

INSTANTIATE_TEST_SUITE_P(Levine, LargeLevineSets,
                         ::testing::Values("cubes-24", "cubes-32", "cubes-48"));

HiddenLines boxes(std::initializer_list<std::pair<Vec3, Vec3>> corners) {
  PartSet set;
  for (const auto& [low, high] : corners)
    set.parts.push_back(
        solid_part(box(low, high), static_cast<std::uint32_t>(set.parts.size() + 1)));
  return HiddenLines(std::move(set));
}

double visible_length(const HiddenLines& lines, std::uint32_t part) {
  double sum = 0;
  for (const Piece& piece : lines.pieces())
    if (piece.part == part && piece.visible) sum += piece.to - piece.from;
  return sum;
}

TEST(HiddenLines, OneCubeShowsNineEdgesFromACorner) {
  HiddenLines lines = boxes({{{0, 0, 0}, {1, 1, 1}}});
  lines.compute(view_from({5, 4, 3}, {0.5, 0.5, 0.5}));
  EXPECT_EQ(lines.counters().front_faces, 3u);
  EXPECT_EQ(lines.counters().edges_displayed, 9u);
  EXPECT_EQ(lines.pieces().size(), 9u);
}

// Seen along the row, the edges of the second cube project onto edges of the first, from inside.
TEST(HiddenLines, EdgesThatProjectOntoEachOther) {
  HiddenLines lines =
      boxes({{{0, 0, 0}, {1, 1, 1}}, {{0, 3, 0}, {1, 4, 1}}, {{0, 6, 0}, {1, 7, 1}}});
  SampleCounts counts;
  for (const Vec3& eye : {Vec3{0.5, -5, 0.5}, Vec3{0.25, -5, 0.5}, Vec3{0, -5, 0}, Vec3{0, -5, 0.5},
                          Vec3{0.5, -1, 0.5}, Vec3{1, -5, 1}, Vec3{2, -2, 1}, Vec3{0.5, 2, 0.5},
                          Vec3{0, 2, 0}, Vec3{0, 5, 0.5}, Vec3{2, 2, 2}, Vec3{-4, -4, 0}}) {
    check(lines, view_from(eye, eye + Vec3{0, 1, 0}), counts);
    check(lines, view_from(eye, {0.5, 3.5, 0.5}), counts);
  }
  EXPECT_GT(counts.hidden, 0u);
}

// With the same far face outline exactly behind the near one nothing of it is covered: its edges
// lie on the outline.
TEST(HiddenLines, AnEdgeOnTheOutlineIsVisible) {
  HiddenLines lines = boxes({{{-1, 1, -1}, {1, 1.5, 1}}, {{-2, 2, -2}, {2, 3, 2}}});
  lines.compute(view_from({0, 0, 0}, {0, 1, 0}));
  EXPECT_EQ(visible_length(lines, 0), 4);
  EXPECT_EQ(visible_length(lines, 1), 4);
}

TEST(HiddenLines, TheEyeInACubeSeesItNotAndIsNotHindered) {
  HiddenLines lines = boxes({{{-1, -1, -1}, {1, 1, 1}}, {{-1, 3, -1}, {1, 4, 1}}});
  for (const Vec3& eye : {Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 1}}) {
    lines.compute(view_from(eye, {0, 3.5, 0}), true);
    EXPECT_EQ(visible_length(lines, 0), 0);
    EXPECT_GT(visible_length(lines, 1), 0);
  }
}

// A floor that reaches behind the eye hides what is below it.
TEST(HiddenLines, ObjectsThatReachBehindTheEye) {
  HiddenLines lines =
      boxes({{{-50, -50, -1}, {50, 50, 0}}, {{-1, 5, -4}, {1, 6, -2}}, {{-1, 5, 1}, {1, 6, 2}}});
  SampleCounts counts;
  for (const Vec3& eye : {Vec3{0, 0, 2}, Vec3{0, 0, 0.5}, Vec3{3, 0, 0}, Vec3{0, 0, -1.5}})
    check(lines, view_from(eye, {0, 5, 0}), counts);
  lines.compute(view_from({0, 0, 2}, {0, 5, 0}));
  EXPECT_EQ(visible_length(lines, 1), 0);
  EXPECT_GT(visible_length(lines, 2), 0);
}

// A fork of a figure: two prongs and a gap through which the cube behind shows.
TEST(HiddenLines, AConcaveFigureHidesByParity) {
  PartSet set;
  set.parts.push_back(solid_part(box({-0.5, 5, -0.5}, {0.5, 6, 0.5}), 1));
  set.parts.push_back(hidden_line::figure_part({{-2, 2, -2},
                                                {2, 2, -2},
                                                {2, 2, 2},
                                                {0.1, 2, 2},
                                                {0.1, 2, -1.5},
                                                {-0.1, 2, -1.5},
                                                {-0.1, 2, 2},
                                                {-2, 2, 2}},
                                               2));
  ASSERT_FALSE(set.parts[1].cells.empty());
  HiddenLines lines(std::move(set));
  SampleCounts counts;
  for (const Vec3& eye : {Vec3{0, -3, 0}, Vec3{0.2, -3, 0.3}, Vec3{0, 8, 0}, Vec3{0.1, 0, 0.5},
                          Vec3{3, 2, 0}, Vec3{0, 1.9, 1.9}}) {
    SCOPED_TRACE(eye.x);
    check(lines, view_from(eye, {0, 4, 0}), counts);
  }
  lines.compute(view_from({0, -3, 0}, {0, 4, 0}));
  // The slit shows 0.1 (8 / 5) to each side of the middle: of four level edges, two near ones here.
  EXPECT_NEAR(visible_length(lines, 0), 2 * 0.2 * 8 / 5, 1e-9);
}

TEST(HiddenLines, AWireFrameHidesNothing) {
  PartSet set;
  set.parts.push_back(solid_part(box({-1, 5, -1}, {1, 6, 1}), 1));
  set.parts.push_back(wire_part(box({-2, 2, -2}, {2, 3, 2}), 2));
  set.parts.push_back(wire_part(box({-0.5, 8, -0.5}, {0.5, 9, 0.5}), 3));
  HiddenLines lines(std::move(set));
  lines.compute(view_from({0, 0, 0}, {0, 5, 0}));
  EXPECT_EQ(visible_length(lines, 0), 4);
  EXPECT_EQ(visible_length(lines, 1), 12);
  EXPECT_EQ(visible_length(lines, 2), 0);
}

// An L of two blocks in one body: an edge far behind projects exactly onto the seam of two front
// faces, and must not shine through; nor may the seam's own edge vanish where it is one.
TEST(HiddenLines, NothingShowsThroughASeam) {
  Environment environment;
  environment.models.push_back({"m", 0});
  // In plan an L; its front at y = 0 is one face, at z = 0..2; the seam is the corner at x = 0.
  Object roof;  // a gable: two front faces meet at the ridge x = 0
  roof.vertices = {{-2, 0, 0}, {2, 0, 0},  {0, -1, 0}, {-2, 0, 4},
                   {2, 0, 4},  {0, -1, 4}, {0, 3, 0},  {0, 3, 4}};
  roof.faces = {{{0, 2, 5, 3}, {}}, {{2, 1, 4, 5}, {}}, {{1, 6, 7, 4}, {}},
                {{6, 0, 3, 7}, {}}, {{0, 6, 1, 2}, {}}, {{3, 5, 4, 7}, {}}};
  // A notch makes it concave: the back is pulled in.
  roof.vertices[6].y = roof.vertices[7].y = -0.25;
  Object needle = box({-0.25, 8, 1}, {0, 9, 3});
  environment.objects = {roof, needle};
  HiddenLines lines(parts_of(environment));
  const ViewTransform view = view_from({0, -10, 2}, {0, 8, 2});
  lines.compute(view, true);
  for (const Piece& piece : lines.pieces())
    EXPECT_FALSE(lines.parts()[piece.part].object == 2 && piece.visible);
  SampleCounts counts;
  EXPECT_EQ(check_pieces(lines, view, 3, counts), "");
  double ridge = 0;
  for (const Piece& piece : lines.pieces()) {
    const hidden_line::Part& part = lines.parts()[piece.part];
    const hidden_line::PartEdge& edge = part.edges[piece.edge];
    if (part.object == 1 && piece.visible && part.vertices[edge.a].y == -1 &&
        part.vertices[edge.b].y == -1)
      ridge += piece.to - piece.from;
  }
  EXPECT_EQ(ridge, 1);
}

// Tiny and huge worlds give the same picture.
TEST(HiddenLines, ScaleDoesNotMatter) {
  Counters first;
  for (const double scale : {1.0, 0x1p-200, 0x1p200, 0x1p-330}) {
    HiddenLines lines = boxes({{Vec3{0, 0, 0} * scale, Vec3{1, 1, 1} * scale},
                               {Vec3{0.25, 3, 0} * scale, Vec3{2, 4, 3} * scale}});
    lines.compute(view_from(Vec3{0.4, -4, 0.7} * scale, Vec3{0.5, 3, 0.5} * scale));
    Counters c = lines.counters();
    c.exact = 0;
    if (scale == 1) first = c;
    EXPECT_EQ(c, first) << scale;
    EXPECT_NEAR(visible_length(lines, 0), 4, 1e-12);
  }
}

TEST(HiddenLines, RefusesPartsWithoutEdges) {
  PartSet set;
  set.parts.emplace_back();
  EXPECT_THROW(HiddenLines{std::move(set)}, std::invalid_argument);
  EXPECT_THROW(hidden_line::figure_part({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 1),
               std::invalid_argument);
  EXPECT_THROW(hidden_line::figure_part({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, 1),
               std::invalid_argument);
  EXPECT_THROW(hidden_line::figure_part({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, 1),
               std::invalid_argument);
}

TEST(HiddenLines, NothingIsDrawnOfAnEmptyWorld) {
  HiddenLines lines{PartSet{}};
  lines.compute(view_from({0, 0, 0}, {0, 1, 0}), true);
  EXPECT_TRUE(lines.pieces().empty());
}

}  // namespace
}  // namespace cigsim::test
