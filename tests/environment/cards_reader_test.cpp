// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "models/environment/cards.hpp"
#include "models/environment/input_error.hpp"

namespace cigsim {
namespace {

constexpr const char* kVertices =
    "'BEGIN STRUCTURE DATA'\n"
    "'VERTEX' X=0, Y=0, Z=0, NEDGES=3, TAG=1; 2 3 4\n"
    "'VERTEX' X=1,Y=0,Z=0,NEDGES=0,TAG=2;\n"
    "'VERTEX' Y=1 X=0 TAG=3;\n"
    "'VERTEX' Y=0 Z=1 TAG=4;\n";
constexpr const char* kFaces =
    "'FACE' LABEL=1, NVERT=3; 1 2 3\n"
    "'FACE' LABEL=2; 1,3,4\n"
    "'FACE' LABEL=3; 1 4\n 2\n"
    "'FACE' LABEL=4; 2 4 3 'END STRUCTURE DATA'\n";
constexpr const char* kView = "'VIEW DATA' R=10 D=2 THETA=30 PHI=20 DR=0 DD=0 DTHETA=0 DPHI=0;\n";

std::string deck(const std::string& rest) { return std::string(kVertices) + kFaces + rest; }

std::string error_of(const std::string& text) {
  try {
    parse_cards(text, "d.cards");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CardsReader, ReadsAStructureAndItsPictures) {
  const CardsDeck read = parse_cards(
      deck(std::string(kView) + "'PLOT' DELAY=1.5; 'VIEW DATA' THETA=-5E1; 'PLOT' ; 'STOP'"),
      "d.cards");
  ASSERT_EQ(read.structures.size(), 1u);
  EXPECT_EQ(read.structures[0].vertices.size(), 4u);
  EXPECT_EQ(read.structures[0].faces.size(), 4u);
  EXPECT_EQ(read.structures[0].faces[1].vertices, (std::vector<std::uint32_t>{0, 2, 3}));
  ASSERT_EQ(read.plots.size(), 2u);
  EXPECT_EQ(read.plots[0].view.theta, 30);
  EXPECT_EQ(read.plots[1].view.theta, -50);
  EXPECT_EQ(read.plots[1].view.r, 10);
  EXPECT_EQ(read.plots[1].delay, 1.5);
  EXPECT_TRUE(read.notices.empty());
}

// GET DATA leaves what is not named.
TEST(CardsReader, ValuesThatAreNotNamedStay) {
  const CardsDeck read = parse_cards(deck("'STOP'"), "d.cards");
  EXPECT_EQ(read.structures[0].vertices[2].position, (Vec3{0, 1, 0}));
  EXPECT_EQ(read.structures[0].vertices[3].position, (Vec3{0, 0, 1}));
}

TEST(CardsReader, TheIncrementsOfAViewCountAtOnce) {
  const CardsDeck read = parse_cards(
      deck(
          "'VIEW DATA' R=10 D=2 THETA=30 PHI=20 DR=1 DD=.5 DTHETA=2 DPHI=-3; 'VIEW DATA' ; 'STOP'"),
      "d.cards");
  EXPECT_EQ(read.view->theta, 34);
  EXPECT_EQ(read.view->phi, 14);
  EXPECT_EQ(read.view->r, 10);
}

// INDEX finds the word anywhere in the first 30 characters.
TEST(CardsReader, AnInstructionIsKnownByAWordWithinIt) {
  EXPECT_EQ(parse_cards(deck("'PLEASE STOP HERE' nonsense"), "d").notices.size(), 1u);
  const CardsDeck read =
      parse_cards(deck("'123456789012345678901234567890STOP' 'IT''S STOP'"), "d.cards");
  ASSERT_EQ(read.reports.size(), 1u);
}

TEST(CardsReader, AnUnknownInstructionIsReportedAndSkipped) {
  const CardsDeck read = parse_cards(deck("'ROTATE' ANGLE=3; 4 5\n'STOP'"), "d.cards");
  ASSERT_EQ(read.reports.size(), 1u);
  EXPECT_EQ(read.reports[0],
            "line 11: 'ROTATE' is not a legal instruction; skipped up to the next quote");
  ASSERT_EQ(read.notices.size(), 1u);
}

TEST(CardsReader, AStructureReplacesTheOneBefore) {
  const CardsDeck read = parse_cards(deck(deck(std::string(kView) + "'PLOT' DELAY=0;'STOP'")), "d");
  EXPECT_EQ(read.structures.size(), 2u);
  EXPECT_EQ(read.plots[0].structure, 1u);
}

struct Bad {
  std::string text, message;
};

TEST(CardsReader, EveryErrorNamesItsLine) {
  const std::string v = kVertices;
  const Bad cases[] = {
      {"'STOP'", "d.cards:1: holds no structure"},
      {"VERTEX X=1;", "d.cards:1: an instruction in quotes"},
      {"\n'VERTEX", "d.cards:2: the quote that begins here is not closed"},
      {v + "'FACE' LABEL=1, NVERT=3; 1 2", "d.cards:6: corner 3 of 3 is missing"},
      {v + "'FACE' LABEL=1, NVERT=3; 1 2 9", "d.cards:6: no 'VERTEX' card has TAG 9"},
      {v + "'FACE' LABEL=1, NVERT=3; 1 2 2", "d.cards:6: the face names vertex 2 twice"},
      {v + "'FACE' LABEL=1, NVERT=2; 1 2", "d.cards:6: NVERT must be a whole number from 3"},
      {v + "'FACE' LABEL=1, NVERT=3 1 2 3", "has no value; write NAME=value"},
      {v + "'FACE' LABEL=1; 1 2 3", "d.cards:6: 'FACE' lacks NVERT"},
      {v + "'FACE' COLOUR=1;", "d.cards:6: 'FACE' has no COLOUR; it has LABEL, NVERT"},
      {v + "'FACE' LABEL=1, NVERT=3 ", "do not end; put a semicolon"},
      {v + "'FACE' LABEL=x, NVERT=3;", "LABEL is \"x\", which is no number"},
      {v + "'FACE' LABEL=nan, NVERT=3;", "which is no number"},
      {v + "'FACE' LABEL=1E999, NVERT=3;", "which is no number"},
      {v + "'FACE' LABEL=1, NVERT=3; 1 2.5 3", "corner 2 of 3 must be a whole number"},
      {v + "'FACE' LABEL=1, NVERT=3; 1 , , 3", "corner 2 of 3 is missing before ','"},
      {v + "'VERTEX' TAG=4;", "d.cards:6: TAG 4 stands twice"},
      {v + "'VERTEX' TAG=0;", "d.cards:6: TAG must be a whole number from 1"},
      {v + "'VERTEX' TAG=5 NEDGES=2; 1 'STOP'", "number 2 of NEDGES = 2 is missing"},
      {v + "'END STRUCTURE DATA'", "d.cards:6: the structure has no 'FACE'"},
      {v, "the structure has no 'END STRUCTURE DATA'"},
      {deck("'END STRUCTURE DATA'"), "d.cards:11: 'END STRUCTURE DATA' twice"},
      {deck("'VERTEX' TAG=5;"), "d.cards:11: 'VERTEX' after 'END STRUCTURE DATA'"},
      {deck("'FACE' LABEL=1;"), "d.cards:11: 'FACE' after 'END STRUCTURE DATA'"},
      {deck("'PLOT' DELAY=1;"), "d.cards:11: 'PLOT' before 'VIEW DATA'"},
      {std::string(kView) + "'PLOT' DELAY=1;", "d.cards:2: 'PLOT' before 'END STRUCTURE DATA'"},
      {deck("'VIEW DATA' R=10 D=0 THETA=0 PHI=0 DR=0 DD=0 DTHETA=0 DPHI=0;"), "D must be above 0"},
      {deck("'VIEW DATA' R=10;"), "'VIEW DATA' lacks D"},
      {deck("STOP"), "d.cards:11: an instruction in quotes"},
  };
  for (const Bad& bad : cases) {
    const std::string error = error_of(bad.text);
    EXPECT_NE(error.find(bad.message), std::string::npos) << bad.text << "\ngives " << error;
  }
}

TEST(CardsReader, TheEnvironmentHasFacesAnticlockwiseAndHisView) {
  const ReadResult read =
      read_environment(std::string(CIGSIM_SOURCE_DIR) + "/scenes/pfister-block.cards");
  ASSERT_EQ(read.environment.objects.size(), 1u);
  const Object& block = read.environment.objects[0];
  EXPECT_EQ(block.vertices.size(), 10u);
  EXPECT_EQ(block.faces.size(), 7u);
  // The front, at z = 2 for him, is the south face.
  const Face& front = block.faces[0];
  const Vec3 n = cross(block.vertices[front.vertices[1]] - block.vertices[front.vertices[0]],
                       block.vertices[front.vertices[2]] - block.vertices[front.vertices[0]]);
  EXPECT_LT(n.y, 0);
  ASSERT_TRUE(read.environment.view);
  EXPECT_EQ(read.environment.view->eye.heading, 20);
  EXPECT_EQ(read.environment.view->eye.pitch, -25);
}

}  // namespace
}  // namespace cigsim
