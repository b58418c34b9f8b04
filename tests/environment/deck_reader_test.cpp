// SPDX-License-Identifier: MIT
// Cards after Stump 1986, app. A: V (2X,I3,3F8.2), F (2X,10I3), S (2X,9F8.2), E.
#include <gtest/gtest.h>

#include "models/environment/deck.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

//                       1234567890123456789012345678901
const std::string kV1 = "V     1    0.00    0.00    0.00\n";
const std::string kV2 = "V     2   10.00    0.00    0.00\n";
const std::string kV3 = "V     3    0.00   10.00    0.00\n";
const std::string kV4 = "V     4    0.00    0.00   10.00\n";
const std::string kVertices = kV1 + kV2 + kV3 + kV4;
const std::string kFaces = "F     1  2  3\nF     1  4  2\nF     2  4  3\nF     1  3  4\n";

std::string error(const std::string& text) {
  return test::message_of([&] { parse_deck(text, "a.deck"); });
}

TEST(DeckReader, FacesTurnAnticlockwiseAndAVCardAfterFCardsStartsAnObject) {
  const StumpDeck deck = parse_deck(kVertices + kFaces + kVertices + kFaces + "E\n", "a.deck");
  ASSERT_EQ(deck.objects.size(), 2u);
  EXPECT_EQ(deck.objects[1].vertices[3], (Vec3{0, 0, 10}));
  // Clockwise 1 2 3 seen from below (the bottom's outside): anticlockwise 3 2 1.
  EXPECT_EQ(deck.objects[0].faces[0].vertices, (std::vector<std::uint32_t>{2, 1, 0}));
  EXPECT_EQ(deck.objects[0].faces.size(), 4u);
}

TEST(DeckReader, F82WithoutAPointHasTwoDecimals) {
  const auto x_of = [](const std::string& field) {
    EXPECT_EQ(field.size(), 8u);
    return parse_deck("V     1" + field + "\n" + kV2 + kV3 + "F     1  2  3\nE\n", "a.deck")
        .objects[0]
        .vertices[0]
        .x;
  };
  EXPECT_EQ(x_of("    1234"), 12.34);
  EXPECT_EQ(x_of("1234    "), 12.34);
  EXPECT_EQ(x_of("  1 2 34"), 12.34);
  EXPECT_EQ(x_of("       5"), 0.05);
  EXPECT_EQ(x_of("     -5."), -5);
  EXPECT_EQ(x_of("   +.125"), 0.125);
  EXPECT_EQ(x_of("   1.5E2"), 150);
  EXPECT_EQ(x_of("   1.5D2"), 150);
  EXPECT_EQ(x_of("   1.5-2"), 0.015);
  EXPECT_EQ(x_of("    15E1"), 1.5);
  EXPECT_EQ(x_of("        "), 0);
}

TEST(DeckReader, OperatorsPlanesKeepTheirOrder) {
  const std::string s1 =
      "S      25.00    0.00    0.00   25.00   10.00    0.00   25.00    0.00   10.00\n";
  const std::string s2 =
      "S       0.00 15.     0.00   10.00   15.00    0.00    0.00   15.00   10.00\n";
  const StumpDeck deck = parse_deck(kVertices + kFaces + s1 + s2 + "E \n", "a.deck");
  ASSERT_EQ(deck.planes.size(), 2u);
  EXPECT_EQ(deck.planes[0], (std::array<Vec3, 3>{Vec3{25, 0, 0}, {25, 10, 0}, {25, 0, 10}}));
  EXPECT_EQ(deck.planes[1][0], (Vec3{0, 15, 0}));
}

TEST(DeckReader, TenVerticesAFaceWindowsLinesAndSequenceNumbers) {
  std::string text;
  for (int i = 1; i <= 10; ++i) {
    char card[100];
    std::snprintf(card, sizeof card, "V   %3d%8.2f%8.2f%8.2f%41s%08d\r\n", i, 1.0 * i, 1.0 * i * i,
                  0.0, "", i);
    text += card;
  }
  text += "F     1  2  3  4  5  6  7  8  9 10\r\nE \r\n";
  EXPECT_EQ(parse_deck(text, "a.deck").objects[0].faces[0].vertices.size(), 10u);
}

TEST(DeckReader, LinesAfterTheEndAreNoticed) {
  EXPECT_TRUE(parse_deck(kVertices + kFaces + "E\n\n", "a.deck").notices.empty());
  EXPECT_EQ(parse_deck(kVertices + kFaces + "E\nV\nV\n", "a.deck").notices.size(), 1u);
}

TEST(DeckReader, EveryFaultIsNamedWithItsLine) {
  EXPECT_EQ(error(kVertices + "X\n"),
            "a.deck:5: unknown card type \"X\"; columns 1-2 must hold V, F, S or E and a blank");
  EXPECT_EQ(error("v     1\n").substr(0, 27), "a.deck:1: unknown card type");
  EXPECT_EQ(error(kVertices + kFaces),
            "a.deck:8: the deck ends without an E card; add a line \"E \"");
  EXPECT_EQ(error("E\n"), "a.deck:1: holds no object; add V and F cards before the E card");
  EXPECT_EQ(error(kFaces), "a.deck:1: an F card before any V card; put the object's V cards first");
  EXPECT_EQ(error(kVertices + "E\n"),
            "a.deck:4: V cards without F cards after them; add the object's faces");
  EXPECT_EQ(error(kV1 + kV1),
            "a.deck:2: vertex 1 stands twice in this object; give each vertex its own number");
  EXPECT_EQ(error(kVertices + "F     1  2  5\n"),
            "a.deck:5: vertex 5 is not among the V cards of this object; correct the number");
  EXPECT_EQ(
      error(kVertices + "F     1  2\n"),
      "a.deck:5: a face needs at least 3 different vertices, not 2; complete or remove the card");
  EXPECT_EQ(error(kVertices + "F     1  2  1  2\n").substr(0, 47),
            "a.deck:5: a face needs at least 3 different ver");
  EXPECT_EQ(error(kVertices + "F     1  2     3\n"),
            "a.deck:5: vertex numbers of an F card must stand side by side from column 5");
  EXPECT_EQ(error("V     1    0.0x    0.00    0.00\n"),
            "a.deck:1: \"    0.0x\" in columns 8-15 is no number; write one in F8.2");
  EXPECT_EQ(error("V     1     NaN    0.00    0.00\n").substr(0, 31),
            "a.deck:1: \"     NaN\" in columns");
  EXPECT_EQ(error("V    -1    0.00    0.00    0.00\n"),
            "a.deck:1: \" -1\" in columns 5-7 is no vertex number; write one in I3, from 1");
  EXPECT_EQ(error("V  \t1 0 0 0\n").substr(0, 29), "a.deck:1: a card holds a tab;");
  EXPECT_EQ(error("V     1    0.00    0.00    0.00 5\n").substr(0, 34),
            "a.deck:1: text in columns 32-72; a");
  EXPECT_EQ(error("S       0.00    0.00    0.00    1.00    0.00    0.00    2.00    0.00    0.00\n"),
            "a.deck:1: the three points of the plane lie on one line; move one of them off it");
}

}  // namespace
}  // namespace cigsim
