// SPDX-License-Identifier: MIT
// The geometry processor's words against rational arithmetic within the error that its page
// derives, and worked by hand.
#include <gtest/gtest.h>

#include "models/geometry_processor/functional_words.hpp"
#include "models/numeric/number.hpp"
#include "tests/support/random_faces.hpp"

namespace cigsim::geometry_processor {
namespace {

/// A memory of one item with the given vertices and one face of all of them.
FaceMemory one_face(const std::vector<Word>& vertices, const Word (&normal)[3]) {
  FaceMemory memory;
  const auto corners = static_cast<Word>(vertices.size() / 3);
  memory.items = {0, 1, 0, corners};
  memory.vertices = vertices;
  memory.faces = {0, corners, normal[0], normal[1], normal[2], 0, 7, 0x030201};
  for (Word c = 0; c < corners; ++c) memory.corners.push_back(c);
  return memory;
}

/// u ahead along x, v right along -y, w up along z.
ViewWords straight_view(const Raster& raster) {
  ViewWords view;
  view.raster = raster;
  view.matrix[0][0] = 1 << 30;
  view.matrix[1][1] = -(1 << 30);
  view.matrix[2][2] = 1 << 30;
  return view;
}

constexpr Word kTowardsEye[3] = {-(1 << 30), 0, 0};

// A square of half the picture's size: its sides cross columns 2 and 6, its top is at line 2.
TEST(GeometryWords, ASquareWorkedByHand) {
  MachineDescription machine;
  machine.raster = {8, 8};
  const FaceMemory memory =
      one_face({1024, 512, 512, 1024, 512, -512, 1024, -512, -512, 1024, -512, 512}, kTowardsEye);
  const GeometryBank bank{straight_view(machine.raster), {&memory, &memory, &memory}};
  EdgeList<MachineWord> out;
  Figures figures;
  const ItemWord items[] = {{}, {SetId::kStatic, 0, true}};
  FunctionalWords(machine).compute(bank, items, out, figures);
  ASSERT_EQ(out.edges.size(), 2u);
  EXPECT_EQ(to_double(out.edges[0].x), 1.5);
  EXPECT_EQ(to_double(out.edges[1].x), 5.5);
  EXPECT_TRUE(out.edges[0].left);
  EXPECT_FALSE(out.edges[1].left);
  for (const Edge<MachineWord>& e : out.edges) {
    EXPECT_EQ(e.slope.raw, 0);
    EXPECT_EQ(e.first_line, 2);
    EXPECT_EQ(e.end_line, 6);
  }
  ASSERT_EQ(out.faces.size(), 1u);
  EXPECT_EQ(out.faces[0].object, 7u);
  EXPECT_EQ(out.faces[0].area, 16.0f);
  EXPECT_EQ(out.faces[0].colour, (Colour{1, 2, 3}));
}

// The same ten times as large fills the picture after clipping by its four sides.
TEST(GeometryWords, AFaceAllRoundFillsThePicture) {
  MachineDescription machine;
  machine.raster = {8, 8};
  const FaceMemory memory = one_face(
      {1024, 5120, 5120, 1024, 5120, -5120, 1024, -5120, -5120, 1024, -5120, 5120}, kTowardsEye);
  const GeometryBank bank{straight_view(machine.raster), {&memory, &memory, &memory}};
  EdgeList<MachineWord> out;
  Figures figures;
  const ItemWord items[] = {{}, {SetId::kStatic, 0, true}};
  FunctionalWords(machine).compute(bank, items, out, figures);
  EXPECT_EQ(figures.clipped_faces, 1u);
  ASSERT_EQ(out.edges.size(), 2u);
  // A cut is truncated towards the inside.
  for (const Edge<MachineWord>& e : out.edges)
    EXPECT_NEAR(to_double(e.x), e.left ? -0.5 : 7.5, 0.001);
  EXPECT_NE(out.edges[0].left, out.edges[1].left);
  EXPECT_EQ(out.faces[0].first_line, 0);
  EXPECT_EQ(out.faces[0].end_line, 8);
}

TEST(GeometryWords, MemoriesThatAreFullEndTheList) {
  MachineDescription machine;
  machine.raster = {8, 8};
  FaceMemory memory =
      one_face({1024, 512, 512, 1024, 512, -512, 1024, -512, -512, 1024, -512, 512}, kTowardsEye);
  const std::vector<Word> face = memory.faces;
  for (int i = 0; i < 2; ++i) memory.faces.insert(memory.faces.end(), face.begin(), face.end());
  memory.items[kFaceCount] = 3;
  const GeometryBank bank{straight_view(machine.raster), {&memory, &memory, &memory}};
  EdgeList<MachineWord> out;
  Figures figures;
  const ItemWord items[] = {{}, {}, {SetId::kStatic, 0, true}};
  const auto compute = [&](std::uint32_t edges, std::uint32_t faces) {
    machine.edge_capacity = edges;
    machine.face_capacity = faces;
    FunctionalWords(machine).compute(bank, items, out, figures);
    EXPECT_EQ(figures.front_faces, out.faces.size());
    EXPECT_EQ(figures.front_faces + figures.dropped, 6u);
    return figures.front_faces;
  };
  EXPECT_EQ(compute(0, 0), 6u);
  EXPECT_EQ(compute(5, 0), 1u) << "two edges are in, and four corners find room for three";
  EXPECT_EQ(compute(6, 0), 2u);
  EXPECT_EQ(compute(3, 0), 0u);
  EXPECT_EQ(compute(0, 4), 4u);
  EXPECT_EQ(compute(11, 4), 4u);
}

// Columns and lines of corners from the words by rational arithmetic, and from them the edges.
TEST(GeometryWords, EdgesAreWithinTheDerivedErrorOfExactOnes) {
  constexpr std::uint64_t kSeed = 20;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  int compared = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    MachineDescription machine;
    machine.formats.quotient_fraction = 16 + 2 * static_cast<int>(random.below(8));
    machine.formats.raster_fraction = 8 + static_cast<int>(random.below(11));
    machine.raster = {static_cast<int>(1 + random.below(1024)),
                      static_cast<int>(1 + random.below(1024))};
    ViewWords view = test::RandomFaces(random, machine).view();
    for (Word& e : view.eye) e = 0;
    const double away = std::ldexp(random.between(0.5, 1), 12 + static_cast<int>(random.below(17)));
    std::vector<Word> vertices;
    for (int i = 0; i < 9; ++i) {
      const double ahead = std::ldexp(static_cast<double>(view.matrix[0][i % 3]), -30);
      vertices.push_back(static_cast<Word>(away * (ahead + 0.3 * random.between(-1, 1))));
    }
    Exact column[3], line[3];
    Exact least = 1 << 30;
    for (int i = 0; i < 3; ++i) {
      Exact p[3];
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          p[r] += Exact(view.matrix[r][c]) * Exact(vertices[static_cast<std::size_t>(3 * i + c)]);
      if (p[0] <= 0) p[0] = 1;  // then the face is not whole in the picture
      least = std::min(least, Exact(p[0] / (1 << 30)));
      column[i] = Exact(machine.raster.width, 2) * (1 + p[1] / p[0]);
      line[i] = Exact(machine.raster.height, 2) * (1 - p[2] / p[0]);
    }
    FaceMemory memory = one_face(vertices, {1 << 30, 1 << 29, 1 << 28});
    memory.faces[kTwoSided] = 1;
    const GeometryBank bank{view, {&memory, &memory, &memory}};
    EdgeList<MachineWord> out;
    Figures figures;
    const ItemWord items[] = {{}, {SetId::kStatic, 0, true}};
    FunctionalWords(machine).compute(bank, items, out, figures);
    if (figures.clipped_faces != 0 || out.edges.empty()) continue;

    const double unit = std::ldexp(1, -machine.formats.raster_fraction);
    const double relative =
        1 / (to_double(least) - 1) + std::ldexp(1, -machine.formats.quotient_fraction);
    const double dx = machine.raster.width / 2.0 * relative + unit / 2;
    const double dy = machine.raster.height / 2.0 * relative + unit / 2;
    std::size_t next = 0;
    for (int i = 0; i < 3 && next < out.edges.size(); ++i) {
      const int j = (i + 1) % 3, top = line[i] < line[j] ? i : j, bottom = i + j - top;
      const int first = ceil_clamped(Exact(line[top] - Exact(1, 2)), 0, machine.raster.height);
      const int end = ceil_clamped(Exact(line[bottom] - Exact(1, 2)), 0, machine.raster.height);
      if (first == end) continue;
      const Edge<MachineWord>& edge = out.edges[next];
      if (edge.first_line != first || edge.end_line != end) break;  // within dy of a line's centre
      ++next;
      const Exact slope = (column[bottom] - column[top]) / (line[bottom] - line[top]);
      const double steep = std::abs(to_double(slope));
      const double height = to_double(Exact(line[bottom] - line[top]));
      if (height < 1 + 4 * dy) continue;
      // Along the edge the ends' errors are shared out; then x's own rounding, the slope's, t's.
      const double bound = (dx + steep * dy) * 1.01 + unit / 2 + unit / 2 +
                           std::abs(to_double(Exact(column[bottom] - column[top]))) *
                               std::ldexp(1, -machine.formats.quotient_fraction);
      const Exact at = column[top] + slope * (Exact(2 * first + 1, 2) - line[top]) - Exact(1, 2);
      EXPECT_NEAR(to_double(edge.x), to_double(at), bound) << "trial " << trial << " edge " << i;
      if (end - first > 1) {
        // Errors of both ends over the height, and the rounding.
        const double slope_bound = 2 * (dx + steep * dy) / (height - 2 * dy) + unit / 2;
        EXPECT_NEAR(to_double(edge.slope), to_double(slope), slope_bound) << "trial " << trial;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 3000);
}

}  // namespace
}  // namespace cigsim::geometry_processor
