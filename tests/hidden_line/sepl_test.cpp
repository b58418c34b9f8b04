// SPDX-License-Identifier: MIT
#include "models/hidden_line/sepl.hpp"

#include <gtest/gtest.h>

namespace cigsim::hidden_line {
namespace {

Part cube(double x, double y, double z, double size, std::uint32_t number) {
  Object box;
  for (int i = 0; i < 8; ++i)
    box.vertices.push_back(
        {x + (i & 1 ? size : 0), y + (i & 2 ? size : 0), z + (i & 4 ? size : 0)});
  for (const auto& loop : {std::vector<std::uint32_t>{0, 2, 3, 1},
                           {0, 1, 5, 4},
                           {0, 4, 6, 2},
                           {1, 3, 7, 5},
                           {2, 6, 7, 3},
                           {4, 5, 7, 6}})
    box.faces.push_back({loop, {}});
  return solid_part(box, number);
}

// Levine 1975, ch. VI.E: the example of fig. 6.1, from its SEPL. The eye is on the minus side of A,
// B and C and on the plus side of D.
class LevineExample : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* const rows[5] = {"0++-", "-+--", "++--", "-+-+", "--0-"};
    const int eye[4] = {-1, -1, -1, 1};
    for (int c = 0; c < 4; ++c) eye_[c] = eye[c];
    for (int r = 0; r < 5; ++r)
      for (int c = 0; c < 4; ++c) entry_[r][c] = rows[r][c] == '+' ? 1 : rows[r][c] == '-' ? -1 : 0;
  }
  int eye_[4], entry_[5][4];
};

// The figure is lost: a column at a time, two cubes lie to the plane x = 0 as their rows say.
TEST_F(LevineExample, SoMatrixOfFigure61) {
  const int expected[5][5] = {
      {9, -1, -1, -1, -1}, {1, 9, 1, -1, -1}, {1, -1, 9, -1, -1}, {1, 1, 1, 9, 0}, {1, 1, 1, 0, 9}};
  for (int l = 0; l < 5; ++l)
    for (int m = 0; m < 5; ++m) {
      if (l == m) continue;
      bool l_near = false, m_near = false;
      for (int c = 0; c < 4; ++c) {
        std::vector<Part> parts;
        for (const int row : {l, m})
          parts.push_back(cube(entry_[row][c] == 0 ? -1 : 3 * entry_[row][c] - 1, 5.0 * (row == m),
                               0, 2, static_cast<std::uint32_t>(row)));
        const Plane plane = axis_plane(0, 0);
        Sepl sepl(parts, std::vector<Plane>{plane}, {1, 0});
        sepl.mark({100.0 * eye_[c], 0, 0});
        const int so = sepl.so(0, 1);
        l_near = l_near || so == 1;
        m_near = m_near || so == -1;
      }
      const int so = l_near && m_near ? 0 : l_near ? 1 : m_near ? -1 : 2;
      EXPECT_EQ(so, expected[l][m]) << l + 1 << " " << m + 1;
    }
}

TEST(Sepl, FacesPartCubesInARow) {
  std::vector<Part> parts;
  for (int i = 0; i < 5; ++i) parts.push_back(cube(3.0 * i, 0, 0, 1, i + 1));
  Sepl sepl(parts, {});
  EXPECT_EQ(sepl.unresolved_pairs(), 0u);
  EXPECT_EQ(sepl.planes(), 4u);
  sepl.mark({-10, 0.5, 0.5});
  for (std::size_t l = 0; l < 5; ++l)
    for (std::size_t m = 0; m < 5; ++m)
      if (l != m) {
        EXPECT_EQ(sepl.so(l, m), l < m ? 1 : -1);
      }
}

// The source's formula reads a pair without a plane as "cannot hide".
TEST(Sepl, APairThatNoPlanePartsIsUnresolved) {
  const std::vector<Part> parts{cube(0, 0, 0, 2, 1), cube(1, 1, 1, 2, 2)};
  Sepl sepl(parts, {});
  EXPECT_EQ(sepl.unresolved_pairs(), 1u);
  sepl.mark({-10, 0, 0});
  EXPECT_EQ(sepl.so(0, 1), 2);
  EXPECT_EQ(sepl.may_hide(0, 1), Sepl::Answer::kUnresolved);
  EXPECT_EQ(sepl.may_hide(1, 0), Sepl::Answer::kUnresolved);
}

// A figure in its own plane counts to either side, as the other of the pair needs.
TEST(Sepl, AFigureBetweenTwoCubes) {
  std::vector<Part> parts{cube(-3, 0, 0, 1, 1), cube(3, 0, 0, 1, 2)};
  parts.push_back(figure_part({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, 3));
  Sepl sepl(parts, std::vector<Plane>{axis_plane(0, 0)}, {2, 0});
  EXPECT_EQ(sepl.planes(), 2u);
  sepl.mark({-10, 0, 0});
  EXPECT_EQ(sepl.so(0, 1), 1);
  EXPECT_EQ(sepl.so(0, 2), 1);
  EXPECT_EQ(sepl.so(2, 1), 1);
}

}  // namespace
}  // namespace cigsim::hidden_line
