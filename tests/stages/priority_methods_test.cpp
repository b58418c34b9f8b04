// SPDX-License-Identifier: MIT
// The two priority methods on the worked examples of their sources.
//
// A node of a group holds all pairs of its TRUE with its FALSE members. A plane whose listed pairs
// are fewer than that stands here as one node a product.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "models/environment/random.hpp"
#include "models/priority_processor/counters.hpp"
#include "models/priority_processor/so_matrix.hpp"

namespace cigsim::priority_processor {
namespace {

constexpr std::uint64_t kA = 1, kB = 2, kC = 4, kD = 8, kAll = 15;

SeparationNode pairs(std::uint64_t true_members, std::uint64_t false_members) {
  SeparationNode node;
  node.true_members = true_members;
  node.false_members = false_members;
  return node;
}

// The digits of the counts of members 0, 1, ..., or "fault".
std::string counts(const std::vector<SeparationNode>& nodes, std::uint64_t eye_true,
                   std::uint64_t active) {
  GroupOrder order;
  order_by_counters(nodes, eye_true, active, order);
  if (!order.unique) return "fault";
  std::string text(order.count, '?');
  for (std::uint32_t k = 0; k < order.count; ++k)
    text[order.member[k]] = static_cast<char>('0' + k);
  return text;
}

TEST(Counters, StumpsNonListableExampleIsAFault) {
  const std::vector<SeparationNode> nodes{pairs(kC, kB), pairs(kD, kA), pairs(kB, kD),
                                          pairs(kC, kA), pairs(kB, kA), pairs(kD, kC)};
  GroupOrder order;
  order_by_counters(nodes, 0, kAll, order);
  EXPECT_FALSE(order.unique);
  ASSERT_EQ(order.count, 4u);
  EXPECT_EQ(order.member[0], 0) << "A alone has count 0";
}

TEST(Counters, StumpsReassignedPairsAreListable) {
  EXPECT_EQ(counts({pairs(kC, kA | kB), pairs(kD, kA | kB), pairs(kB, kA), pairs(kD, kC)}, 0, kAll),
            "0123");
}

TEST(Counters, ListByCountFindsStumpsCountsNotUnique) {
  const auto unique = [](std::array<std::uint8_t, 4> c) {
    std::array<std::uint8_t, kGroupCapacity> all{};
    std::copy(c.begin(), c.end(), all.begin());
    GroupOrder order;
    list_by_count(kAll, all, order);
    return order.unique;
  };
  EXPECT_FALSE(unique({0, 0, 1, 1}));
  EXPECT_FALSE(unique({0, 1, 2, 1}));
  EXPECT_FALSE(unique({0, 2, 2, 2}));
  EXPECT_TRUE(unique({0, 1, 2, 3}));
  EXPECT_TRUE(unique({3, 0, 2, 1}));
}

TEST(Counters, AtAFaultMembersStayInTheOrderOfCountThenNumber) {
  std::array<std::uint8_t, kGroupCapacity> c{};
  c[0] = 2;
  c[1] = 0;
  c[2] = 2;
  c[3] = 2;
  GroupOrder order;
  list_by_count(kAll, c, order);
  EXPECT_FALSE(order.unique);
  EXPECT_EQ(order.member[0], 1);
  EXPECT_EQ(order.member[1], 0);
  EXPECT_EQ(order.member[2], 2);
  EXPECT_EQ(order.member[3], 3);
}

TEST(Counters, StumpsFirstTestCase) {
  const std::vector<SeparationNode> nodes{pairs(2, 1)};
  EXPECT_EQ(counts(nodes, 1, 3), "10");
  EXPECT_EQ(counts(nodes, 0, 3), "01");
}

TEST(Counters, StumpsSecondTestCaseInItsFourRegions) {
  const std::vector<SeparationNode> nodes{pairs(4 | 8, 1 | 2), pairs(8, 4), pairs(2, 1)};
  std::set<std::string> regions;
  for (const std::uint64_t first : {0, 1})
    for (const std::uint64_t second : {0, 6}) regions.insert(counts(nodes, first | second, 15));
  EXPECT_EQ(regions, (std::set<std::string>{"2301", "3210", "1032", "0123"}));
}

TEST(Counters, StumpsThirdTestCaseInItsNineRegions) {
  const std::vector<SeparationNode> nodes{pairs(16, 15), pairs(8, 7), pairs(4, 3), pairs(2, 1)};
  std::set<std::string> regions;
  for (const double x : {5, 20, 30})
    for (const double y : {5, 20, 30})
      regions.insert(
          counts(nodes, (x >= 25) | (y >= 25) << 1 | (x >= 10) << 2 | (y >= 10) << 3, 31));
  EXPECT_EQ(regions, (std::set<std::string>{"01234", "10234", "21304", "32104", "43210", "32140",
                                            "23140", "12034", "21034"}));
}

// Levine's five objects and planes A to D; the eyepoint on the minus side of A, B and C.
const std::vector<SeparationNode> kLevine{
    pairs(1 << 2, 1 << 1 | 1 << 3 | 1 << 4), pairs(1 << 0 | 1 << 1 | 1 << 2 | 1 << 3, 1 << 4),
    pairs(1 << 0, 1 << 1 | 1 << 2 | 1 << 3), pairs(1 << 3, 1 << 0 | 1 << 1 | 1 << 2 | 1 << 4)};
constexpr std::uint64_t kLevineEye = 8;

TEST(SoMatrix, LevinesRowsAreMarkedAsPrinted) {
  const auto rows = marked_sepl(kLevine, kLevineEye);
  const std::array<std::string, 5> want{"-000", "1010", "0010", "1011", "11-0"};
  for (std::size_t o = 0; o < want.size(); ++o) {
    std::string got;
    for (int plane = 0; plane < 4; ++plane)
      got += !(rows[o].s >> plane & 1) ? '-' : rows[o].r >> plane & 1 ? '1' : '0';
    EXPECT_EQ(got, want[o]) << "object " << o + 1;
  }
}

TEST(SoMatrix, LevinesTenPairs) {
  const auto rows = marked_sepl(kLevine, kLevineEye);
  const std::array<std::string, 5> want{".----", "+.+--", "+-.--", "+++.0", "+++0."};
  for (std::size_t l = 0; l < 5; ++l)
    for (std::size_t m = 0; m < 5; ++m) {
      if (l == m) continue;
      const Separation so = separating_object(rows[l], rows[m]);
      const char got = so == Separation::kHides     ? '+'
                       : so == Separation::kHidden  ? '-'
                       : so == Separation::kNeither ? '0'
                                                    : '?';
      EXPECT_EQ(got, want[l][m]) << "objects " << l + 1 << " and " << m + 1;
    }
}

TEST(SoMatrix, IsAntiSymmetricAndTellsPairsThatNoPlaneParts) {
  const std::uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::array<int, 4> answers{};
  for (int k = 0; k < 20000; ++k) {
    SeplRow l, m;
    // Few planes, so that all four answers come up.
    const std::uint64_t some = random.bits() & random.bits() & random.bits() & random.bits();
    l.s = random.bits() & some;
    m.s = random.bits() & some;
    l.r = random.bits() & l.s;
    m.r = random.bits() & m.s;
    const Separation lm = separating_object(l, m), ml = separating_object(m, l);
    ++answers[static_cast<std::size_t>(static_cast<int>(lm) + 1)];
    if (lm == Separation::kHides || lm == Separation::kHidden)
      ASSERT_EQ(static_cast<int>(ml), -static_cast<int>(lm));
    else
      ASSERT_EQ(ml, lm);
    bool parted = false;
    for (int plane = 0; plane < 64; ++plane)
      parted = parted || ((l.s & m.s) >> plane & 1 && ((l.r ^ m.r) >> plane & 1));
    ASSERT_EQ(lm == Separation::kUnresolved, !parted);
  }
  for (const int count : answers) EXPECT_GT(count, 100);
  EXPECT_EQ(separating_object({1, 1}, {1, 1}), Separation::kUnresolved) << "the zero diagonal";
}

TEST(SoMatrix, APairWithoutAPlaneIsAFault) {
  GroupOrder order;
  order_by_so_matrix(std::vector<SeparationNode>{pairs(1, 2)}, 0, 7, order);
  EXPECT_FALSE(order.unique);
}

}  // namespace
}  // namespace cigsim::priority_processor
