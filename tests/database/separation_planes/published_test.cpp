// SPDX-License-Identifier: MIT
// Stump's program as published: his three cases, line for line and region for region, and its weak
// points.
#include "models/database/separation_planes/published.hpp"

#include <gtest/gtest.h>

#include "models/database/listability/listability.hpp"
#include "models/database/prepare.hpp"
#include "models/environment/input_error.hpp"
#include "models/priority_processor/functional.hpp"
#include "tests/database/separation_planes/decks.hpp"

namespace cigsim::separation_planes {
namespace {

using test::case_deck;
using test::deck_of;

PublishedTable table_of(const StumpDeck& deck) { return PublishedProgram(deck, "a.deck").run(); }

Database database_of(const StumpDeck& deck, const PublishedTable& table) {
  Environment environment;
  environment.models.push_back({"deck", 0});
  environment.objects = deck.objects;
  for (const ChosenPlane& p : table.planes)
    environment.separation.push_back({p.plane.normal, p.plane.distance, p.pairs});
  return prepare(environment);
}

// The counts of objects 1, 2, ... as digits, by the machine's own counters and sides.
std::string counts_from(const Database& database, const Vec3& eye) {
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  std::uint64_t eye_true = 0;
  for (std::size_t n = 0; n < hierarchy.nodes.size(); ++n)
    eye_true |= std::uint64_t{priority_processor::eye_on_true_side<double>(
                    hierarchy.planes[hierarchy.nodes[n].plane], eye)}
                << n;
  const std::uint64_t all = (std::uint64_t{1} << hierarchy.members.size()) - 1;
  const auto counts = priority_processor::counters(hierarchy.nodes, eye_true, all, hierarchy.pairs);
  std::string text;
  for (std::size_t m = 0; m < hierarchy.members.size(); ++m)
    text += static_cast<char>('0' + counts[m]);
  return text;
}

void expect_listable(const Database& database, std::uint32_t objects) {
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  listability::PriorityTable table{objects, hierarchy.planes, {}};
  for (std::uint32_t n = 0; n < hierarchy.nodes.size(); ++n)
    for (std::uint32_t p = 0; p < hierarchy.nodes[n].pair_count; ++p) {
      const MemberPair pair = hierarchy.pairs[hierarchy.nodes[n].first_pair + p];
      table.pairs.push_back({n, pair.true_member, pair.false_member});
    }
  EXPECT_TRUE(listability::prove(table).listable);
}

TEST(Stump, TestCase1Fig10) {
  EXPECT_EQ(published_report(table_of(case_deck(1))),
            "NUMBER OF SEPARATION PLANES REQUIRED =   1\n"
            "\n"
            "FOR PLANE NUMBER  1\n"
            "THE UNIT NORMAL IS:  1.0  0.0  0.0\n"
            "AND THE DIRECTED DISTANCE IS: 10.0\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              2         1\n"
            "NORMAL TERMINATION\n");
}

TEST(Stump, TestCase1Counts) {
  const StumpDeck deck = case_deck(1);
  const Database database = database_of(deck, table_of(deck));
  EXPECT_EQ(counts_from(database, {15, 5, 50}), "10");
  EXPECT_EQ(counts_from(database, {10, 5, 50}), "10") << "on the plane counts as TRUE";
  EXPECT_EQ(counts_from(database, {5, 5, 50}), "01");
  expect_listable(database, 2);
}

TEST(Stump, TestCase2Fig13) {
  EXPECT_EQ(published_report(table_of(case_deck(2))),
            "NUMBER OF SEPARATION PLANES REQUIRED =   2\n"
            "\n"
            "FOR PLANE NUMBER  1\n"
            "THE UNIT NORMAL IS: -1.0  0.0  0.0\n"
            "AND THE DIRECTED DISTANCE IS:-60.0\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              3         1\n"
            "                                              3         2\n"
            "                                              4         1\n"
            "                                              4         2\n"
            "FOR PLANE NUMBER  2\n"
            "THE UNIT NORMAL IS:  0.7  0.7  0.0\n"
            "AND THE DIRECTED DISTANCE IS: 14.1\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              4         3\n"
            "                                              2         1\n"
            "NORMAL TERMINATION\n");
}

TEST(Stump, TestCase2HasFiveOf27CandidatesThatSplitAllFour) {
  const PublishedProgram program(case_deck(2), "case 2");
  ASSERT_EQ(program.candidates().size(), 27u);
  int split_two_and_two = 0;
  for (std::size_t c = 0; c < 27; ++c) {
    int plus = 0, minus = 0;
    for (std::size_t o = 0; o < 4; ++o) {
      plus += program.state(c, o) > 0;
      minus += program.state(c, o) < 0;
    }
    split_two_and_two += plus == 2 && minus == 2;
  }
  EXPECT_EQ(split_two_and_two, 5);
}

TEST(Stump, TestCase2Counts) {
  const StumpDeck deck = case_deck(2);
  const Database database = database_of(deck, table_of(deck));
  EXPECT_EQ(counts_from(database, {0, -200, 10}), "2301") << "VP1";
  EXPECT_EQ(counts_from(database, {0, 200, 10}), "3210") << "VP2";
  EXPECT_EQ(counts_from(database, {100, 0, 10}), "1032") << "VP3";
  EXPECT_EQ(counts_from(database, {100, -200, 10}), "0123") << "VP4";
  expect_listable(database, 4);
}

TEST(Stump, TestCase3Fig17) {
  EXPECT_EQ(published_report(table_of(case_deck(3))),
            "NUMBER OF SEPARATION PLANES REQUIRED =   4\n"
            "\n"
            "FOR PLANE NUMBER  1\n"
            "THE UNIT NORMAL IS:  1.0  0.0  0.0\n"
            "AND THE DIRECTED DISTANCE IS: 25.0\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              5         1\n"
            "                                              5         2\n"
            "                                              5         3\n"
            "                                              5         4\n"
            "FOR PLANE NUMBER  2\n"
            "THE UNIT NORMAL IS:  0.0  1.0  0.0\n"
            "AND THE DIRECTED DISTANCE IS: 25.0\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              4         1\n"
            "                                              4         2\n"
            "                                              4         3\n"
            "FOR PLANE NUMBER  3\n"
            "THE UNIT NORMAL IS:  1.0  0.0  0.0\n"
            "AND THE DIRECTED DISTANCE IS: 10.0\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              3         1\n"
            "                                              3         2\n"
            "FOR PLANE NUMBER  4\n"
            "THE UNIT NORMAL IS:  0.0  1.0  0.0\n"
            "AND THE DIRECTED DISTANCE IS: 10.0\n"
            "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:   TRUE      FALSE\n"
            "                                           -----     -----\n"
            "                                              2         1\n"
            "NORMAL TERMINATION\n");
}

TEST(Stump, TestCase3Counts) {
  const StumpDeck deck = case_deck(3);
  const Database database = database_of(deck, table_of(deck));
  const double at[3] = {5, 20, 30};
  const char* want[3][3] = {
      {"01234", "10234", "21304"}, {"12034", "21034", "32104"}, {"23140", "32140", "43210"}};
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      EXPECT_EQ(counts_from(database, {at[x], at[y], 100}), want[x][y])
          << "x " << at[x] << ", y " << at[y];
  expect_listable(database, 5);
}

// Two cubes of side 0.0004, as far apart: no vertex of one is 0.001 from a face of the other.
TEST(Stump, ToleranceIsWrongAtSmallScale) {
  const double s = 0.0004;
  const StumpDeck deck = deck_of({{{0, 0, 0}, {s, s, s}}, {{2 * s, 0, 0}, {3 * s, s, s}}});
  EXPECT_FALSE(table_of(deck).found);
  EXPECT_EQ(published_report(table_of(deck)), "SEPARATION PLANES COULD NOT BE FOUND.\n");
}

// The same the other way round: two boxes that reach 0.0009 into each other pass for apart.
TEST(Stump, ToleranceLetsObjectsOverlap) {
  const StumpDeck deck = deck_of({{{0, 0, 0}, {10, 10, 10}}, {{9.9991, 0, 0}, {20, 10, 10}}});
  EXPECT_TRUE(table_of(deck).found);
}

TEST(Stump, ThreeCollinearFirstVerticesDivideByZero) {
  StumpDeck deck = deck_of({{{0, 0, 0}, {10, 10, 10}}, {{20, 0, 0}, {30, 10, 10}}});
  // A vertex in the middle of an edge, between the two that begin the face.
  Object& object = deck.objects[1];
  Face& face = object.faces[2];
  object.vertices.push_back(
      (object.vertices[face.vertices[0]] + object.vertices[face.vertices[1]]) * 0.5);
  face.vertices.insert(face.vertices.begin() + 1,
                       static_cast<std::uint32_t>(object.vertices.size() - 1));
  std::rotate(face.vertices.begin(), face.vertices.begin() + 3, face.vertices.end());
  EXPECT_THROW(table_of(deck), InputError);
}

// A double pyramid whose waist lies in a plane: no face is cut, so he takes it for whole. Its last
// face decides.
TEST(Stump, AWaistIsNotSeenAsCut) {
  StumpDeck deck = deck_of({{{20, 0, 0}, {30, 10, 10}}});
  Object pyramid;
  pyramid.vertices = {{0, 0, 5}, {8, 0, 5}, {8, 8, 5}, {0, 8, 5}, {4, 4, 0}, {4, 4, 10}};
  for (const auto& face : std::vector<std::vector<std::uint32_t>>{
           {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}, {0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 0, 5}})
    pyramid.faces.push_back({face, std::nullopt});
  deck.objects.push_back(pyramid);
  deck.planes.push_back({Vec3{0, 0, 5}, Vec3{1, 0, 5}, Vec3{1, 1, 5}});
  const PublishedProgram program(deck, "waist");
  const std::size_t card = program.candidates().size() - 1;
  EXPECT_NE(program.state(card, 1), 0) << "though the plane cuts it in two halves";
  EXPECT_EQ(program.state(card, 0), 0) << "the box is seen as cut";
}

// A plane that cuts three of five objects and parts the others one and one is as good for him as
// one that cuts nothing and parts all in halves.
TEST(Stump, CutObjectsCountForNeitherSideInATie) {
  StumpDeck deck = deck_of({{{0, 0, 0}, {1, 1, 1}},
                            {{0, 9, 0}, {1, 10, 1}},
                            {{20, 4, 0}, {21, 6, 1}},
                            {{22, 4, 0}, {23, 6, 1}},
                            {{24, 4, 0}, {25, 6, 1}}});
  deck.planes.push_back({Vec3{0, 5, 0}, Vec3{1, 5, 0}, Vec3{1, 5, 1}});
  const PublishedProgram program(deck, "tie");
  const std::size_t card = program.candidates().size() - 1;
  int sum = 0, cut = 0;
  for (std::size_t o = 0; o < 5; ++o) {
    sum += program.state(card, o);
    cut += program.state(card, o) == 0;
  }
  EXPECT_EQ(cut, 3);
  EXPECT_EQ(sum, 0);
}

TEST(Stump, GivesUpWhereNoCandidateWorks) { EXPECT_FALSE(table_of(test::ring_of_bars()).found); }

TEST(Stump, LimitsOfHisArraysAreClearErrors) {
  std::vector<std::pair<Vec3, Vec3>> extents;
  for (int k = 0; k < 9; ++k) extents.push_back({{20.0 * k, 0, 0}, {20.0 * k + 10, 10, 10}});
  const StumpDeck nine = deck_of(extents);
  try {
    check_published_limits(nine, "nine.deck");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("nine.deck: 216 vertex numbers"), 0u) << error.what();
  }
  extents.resize(8);
  StumpDeck eight = deck_of(extents);
  EXPECT_NO_THROW(check_published_limits(eight, "eight.deck"));
  for (int k = 0; k < 13; ++k)
    eight.planes.push_back({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}});
  EXPECT_THROW(check_published_limits(eight, "eight.deck"), InputError) << "64 + 39 vertices";
}

TEST(Stump, FieldsThatOverflowAreAsterisks) {
  const StumpDeck deck = deck_of({{{0, 0, 0}, {5000, 10, 10}}, {{6000, 0, 0}, {7000, 10, 10}}});
  EXPECT_NE(published_report(table_of(deck)).find("DISTANCE IS:*****"), std::string::npos);
}

}  // namespace
}  // namespace cigsim::separation_planes
