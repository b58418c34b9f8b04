// SPDX-License-Identifier: MIT
// Parts of the priority processor under Icarus against plain arithmetic: the plane side and the
// object counters, at several sizes.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "models/environment/random.hpp"
#include "tests/rtl/icarus.hpp"

namespace cigsim {
namespace {

using Rows = std::vector<std::vector<std::uint64_t>>;
__extension__ using Wide = __int128;

/// A whole coordinate or a component of a normal, extreme ones among them.
std::int32_t word(Random& random, int bits) {
  const std::int64_t limit = std::int64_t{1} << bits;
  switch (random.below(6)) {
    case 0:
      return static_cast<std::int32_t>(limit - 1);
    case 1:
      return static_cast<std::int32_t>(-limit);
    case 2:
      return static_cast<std::int32_t>(random.below(3)) - 1;
    default:
      return static_cast<std::int32_t>(static_cast<std::int64_t>(random.bits()) >> (63 - bits));
  }
}

TEST(PlaneSideRtl, TellsTheSignOfNTimesRLessD) {
  if (!test::has_icarus()) GTEST_SKIP() << "Icarus Verilog (iverilog) is not installed";
  Random random(20);
  Rows rows;
  struct Plane {
    std::size_t row;  ///< after which the sum is complete
    Wide sum;
  };
  std::vector<Plane> planes;
  int zeros = 0, falses = 0;
  for (int n = 0; n < 4000; ++n) {
    std::int32_t eye[3], normal[3];
    Wide sum = 0;
    const auto as_word = [](std::int64_t value) { return static_cast<std::uint32_t>(value); };
    for (unsigned i = 0; i < 3; ++i) {
      eye[i] = word(random, 30);
      rows.push_back({1u << i, 0, 0, 0, as_word(eye[i])});
    }
    for (unsigned i = 0; i < 3; ++i) {
      normal[i] = word(random, 29);
      sum += Wide{normal[i]} * eye[i];
      rows.push_back({0, 1u << i, 0, 0, as_word(normal[i])});
      if (random.below(3) == 0) rows.push_back({0, 0, 0, 0, as_word(eye[i])});  // nothing happens
    }
    auto distance = static_cast<std::int64_t>(random.bits()) >> 1 >> random.below(30);
    if (random.below(4) == 0) distance = static_cast<std::int64_t>(sum) + random.below(3) - 1;
    rows.push_back({0, 0, 1, 0, as_word(distance)});
    rows.push_back({0, 0, 0, 1, as_word(distance >> 32)});
    sum -= distance;
    planes.push_back({rows.size(), sum});
    zeros += sum == 0;
    falses += sum < 0;
  }
  rows.push_back({0, 0, 0, 0, 0});
  const auto outputs = test::run_icarus(
      {"plane_side",
       {"priority_processor/plane_side.sv"},
       {{"load_eye_i", 3}, {"product_i", 3}, {"take_low_i", 1}, {"take_high_i", 1}, {"word_i", 32}},
       {{"eye_true_o", 1}, {"accumulator_o", 64}},
       {}},
      rows);
  for (const Plane& plane : planes) {
    ASSERT_EQ(outputs[plane.row][1], static_cast<std::uint64_t>(plane.sum));
    ASSERT_EQ(outputs[plane.row][0], static_cast<std::uint64_t>(plane.sum >= 0));
  }
  EXPECT_GT(zeros, 100);
  EXPECT_GT(falses, 100);
}

/// Groups of active members whose pairs are counted, then listed by count, and after a fault by
/// count and number.
class CounterGroups {
 public:
  CounterGroups(std::uint64_t seed, std::uint32_t members) : random_(seed), members_(members) {
    for (int n = 0; n < 60; ++n) group();
  }

  /// Inputs, and the outputs under them where they matter.
  Rows rows;
  struct Expected {
    std::size_t row;
    std::uint64_t list, place, listed;
    std::optional<std::uint64_t> fault;
  };
  std::vector<Expected> expected;
  int faults = 0, good = 0, saturated = 0;

 private:
  enum Input {
    kClear,
    kPair,
    kTrue,
    kFalse,
    kEye,
    kActive,
    kListClear,
    kCount,
    kRank,
    kMember,
    kRankNumber
  };

  std::vector<std::uint64_t>& row() {
    rows.emplace_back(11);
    rows.back()[kActive] = active_;
    return rows.back();
  }
  void pair(std::uint32_t t, std::uint32_t f, bool eye) {
    auto& r = row();
    r[kPair] = 1;
    r[kTrue] = t;
    r[kFalse] = f;
    r[kEye] = eye;
    if ((active_ >> t & 1) && (active_ >> f & 1)) ++counts_[eye ? f : t];
  }
  void group() {
    active_ = random_.bits() | random_.bits();
    if (members_ < 64) active_ &= (std::uint64_t{1} << members_) - 1;
    counts_.assign(members_, 0);
    row()[kClear] = 1;
    if (random_.below(2)) {  // a chain of all, which is listable
      std::vector<std::uint32_t> order(members_);
      for (std::uint32_t m = 0; m < members_; ++m) order[m] = m;
      for (std::uint32_t m = members_; m-- > 1;) std::swap(order[m], order[random_.below(m + 1)]);
      for (std::uint32_t a = 0; a < members_; ++a)
        for (std::uint32_t b = a + 1; b < members_; ++b)
          random_.below(2) ? pair(order[a], order[b], true) : pair(order[b], order[a], false);
    } else {
      for (std::uint32_t n = random_.below(300); n-- > 0;) {
        const std::uint32_t t = random_.below(members_);
        pair(t, (t + 1 + random_.below(members_ - 1)) % members_, random_.below(8) == 0);
      }
      for (std::uint32_t n = random_.below(2) * 70; n-- > 0;) pair(0, 1, true);
    }
    for (auto& count : counts_) {
      saturated += count > 63;
      count = std::min(count, std::uint64_t{63});
    }
    row()[kListClear] = 1;
    std::set<std::uint64_t> seen;
    std::uint64_t listed = 0, largest = 0;
    for (std::uint32_t m = 0; m < members_; ++m) {
      if (!(active_ >> m & 1)) continue;
      auto& r = row();
      r[kCount] = 1;
      r[kMember] = m;
      expected.push_back({rows.size() - 1, 1, counts_[m], listed, std::nullopt});
      ++listed;
      seen.insert(counts_[m]);
      largest = std::max(largest, counts_[m]);
    }
    const bool fault = listed != 0 && (seen.size() != listed || largest >= listed);
    row();
    expected.push_back({rows.size() - 1, 0, 0, listed, fault});
    ++(fault ? faults : good);
    if (fault) ranks();
  }
  void ranks() {
    row()[kListClear] = 1;
    std::uint64_t listed = 0;
    for (std::uint64_t rank = 0; rank < 64; ++rank)
      for (std::uint32_t m = 0; m < members_; ++m) {
        if (!(active_ >> m & 1)) continue;
        auto& r = row();
        r[kRank] = 1;
        r[kMember] = m;
        r[kRankNumber] = rank;
        const bool now = counts_[m] == rank;
        expected.push_back({rows.size() - 1, now, listed, listed, std::nullopt});
        listed += now;
      }
  }

  Random random_;
  std::uint32_t members_;
  std::uint64_t active_ = 0;
  std::vector<std::uint64_t> counts_;
};

void counters(std::uint32_t members) {
  if (!test::has_icarus()) GTEST_SKIP() << "Icarus Verilog (iverilog) is not installed";
  SCOPED_TRACE(std::to_string(members) + " members");
  const CounterGroups groups(members, members);
  unsigned member_bits = 1, listed_bits = 1;
  while (1u << member_bits < members) ++member_bits;
  while (1u << listed_bits < members + 1) ++listed_bits;
  const auto outputs = test::run_icarus(
      {"object_counters",
       {"priority_processor/object_counters.sv"},
       {{"clear_i", 1},
        {"pair_i", 1},
        {"true_member_i", 6},
        {"false_member_i", 6},
        {"eye_true_i", 1},
        {"active_i", members},
        {"list_clear_i", 1},
        {"list_count_i", 1},
        {"list_rank_i", 1},
        {"member_i", member_bits},
        {"rank_i", 6}},
       {{"list_o", 1}, {"place_o", member_bits}, {"listed_o", listed_bits}, {"fault_o", 1}},
       {"Members(" + std::to_string(members) + ")"}},
      groups.rows);
  for (const auto& e : groups.expected) {
    SCOPED_TRACE("row " + std::to_string(e.row));
    ASSERT_EQ(outputs[e.row][0], e.list);
    if (e.list) {
      ASSERT_EQ(outputs[e.row][1], e.place & ((1u << member_bits) - 1));
    }
    ASSERT_EQ(outputs[e.row][2], e.listed);
    if (e.fault) {
      ASSERT_EQ(outputs[e.row][3], *e.fault);
    }
  }
  EXPECT_GT(groups.faults, 10);
  EXPECT_GT(groups.good, 10);
  EXPECT_GT(groups.saturated, 0);
}

TEST(ObjectCountersRtl, CountAndCheckTwoMembers) { counters(2); }
TEST(ObjectCountersRtl, CountAndCheckFiveMembers) { counters(5); }
TEST(ObjectCountersRtl, CountAndCheck64Members) { counters(64); }

}  // namespace
}  // namespace cigsim
