// SPDX-License-Identifier: MIT
// The priority processor's RTL in lock-step with the clocked level: every pin in every cycle, and
// the figures, over random hierarchies, prepared worlds and Stump's worked examples.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/levels/priority_bench.hpp"
#include "tests/levels/priority_random_case.hpp"
#include "tests/levels/priority_table_case.hpp"
#include "tests/levels/priority_world_case.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim::priority_processor {
namespace {

using namespace test::stump;
using test::PriorityBench;
using test::PriorityCase;

struct Size {
  unsigned members, levels;
};
constexpr Size kShipped{64, 64}, kSmall{8, 4}, kOdd{5, 3};

std::filesystem::path library(Size size) {
  return std::filesystem::path(CIGSIM_RTL_LIBRARIES) /
         ("priority_processor-Members=" + std::to_string(size.members) +
          "-Levels=" + std::to_string(size.levels) + ".so");
}

/// Compares the pins of two benches at the end of each cycle, from cycle 0 on.
class PinComparison : public sc_core::sc_module {
 public:
  PinComparison(sc_core::sc_module_name name, const Clock& clock, const PriorityBench& expected,
                const PriorityBench& got)
      : sc_module(name), clock_(clock), expected_(expected), got_(got) {
    SC_HAS_PROCESS(PinComparison);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
  }

  std::string difference;  ///< the first one
  Cycle cycles = 0;

 private:
  static std::string pins(const PriorityBench& bench) {
    const Wires<FrameWord>& start = bench.start_wires();
    const Wires<ItemWord>& items = bench.item_wires();
    std::ostringstream text;
    text << "start " << start.valid.read() << start.ready.read() << ' ' << start.word.read()
         << ", items " << items.valid.read() << items.ready.read() << ' ' << items.word.read();
    return text.str();
  }
  template <class T>
  static bool same(const Wires<T>& a, const Wires<T>& b) {
    return a.valid.read() == b.valid.read() && a.ready.read() == b.ready.read() &&
           a.word.read() == b.word.read();
  }
  void edge() {
    ++cycles;
    if (!difference.empty() || (same(expected_.start_wires(), got_.start_wires()) &&
                                same(expected_.item_wires(), got_.item_wires())))
      return;
    difference = "cycle " + std::to_string(clock_.cycle()) + ": expected " + pins(expected_) +
                 ", got " + pins(got_);
  }

  const Clock& clock_;
  const PriorityBench &expected_, &got_;
};

/// Cases at the clocked and the RTL level, a pair of benches each. Use after fresh_simulation().
class LockStep {
 public:
  void add(const PriorityCase& c, Size size, std::uint32_t seed) {
    const PriorityBench& clocked = benches_.emplace_back(c, PriorityBench::kClocked, clock_);
    const PriorityBench& rtl = benches_.emplace_back(c, library(size), seed, clock_);
    pins_.emplace_back(sc_core::sc_gen_unique_name("pins"), clock_, clocked, rtl);
  }
  void run(Cycle cycles) {
    test::run_benches(clock_, benches_, cycles);
    for (std::size_t i = 0; i < pins_.size(); ++i) {
      SCOPED_TRACE("case " + std::to_string(i));
      ASSERT_EQ(pins_[i].difference, "");
      ASSERT_GT(pins_[i].cycles, 0);
      ASSERT_TRUE(benches_[2 * i].done() && rtl(i).done());
      EXPECT_EQ(rtl(i).history, benches_[2 * i].history);
      ASSERT_EQ(rtl(i).figures, benches_[2 * i].figures);
    }
  }
  const PriorityBench& rtl(std::size_t i) const { return benches_[2 * i + 1]; }
  std::size_t cases() const { return pins_.size(); }

 private:
  Clock clock_{"clock", 125};
  std::deque<PriorityBench> benches_;
  std::deque<PinComparison> pins_;
};

void random_cases(Size size, std::uint32_t most_levels, std::uint64_t first_seed) {
  constexpr std::uint64_t kCases = 40;
  test::fresh_simulation();
  std::deque<test::PriorityRandomCase> cases;
  LockStep lock_step;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    cases.emplace_back(first_seed + i, test::PriorityLimits{size.members, most_levels});
    lock_step.add(cases.back().bench, size, static_cast<std::uint32_t>(first_seed + i));
  }
  SCOPED_TRACE("seeds from " + std::to_string(first_seed));
  lock_step.run(2'000'000);
  std::size_t faults = 0, drops = 0, stalls = 0, pairs = 0;
  for (std::size_t i = 0; i < lock_step.cases(); ++i)
    for (const Figures& f : lock_step.rtl(i).figures) {
      faults += f.faults.size();
      drops += f.dropped;
      stalls += f.activity.stalled > 0;
      pairs += f.pairs;
    }
  EXPECT_GT(faults, 20u);
  EXPECT_GT(drops, 5u);
  EXPECT_GT(stalls, 20u);
  EXPECT_GT(pairs, 1000u);
}

TEST(PriorityProcessorRtl, AgreesOnEveryPinAtTheShippedSize) { random_cases(kShipped, 4, 1); }
TEST(PriorityProcessorRtl, AgreesOnEveryPinInDeepHierarchies) { random_cases(kShipped, 20, 1000); }
TEST(PriorityProcessorRtl, AgreesOnEveryPinAtASmallSize) { random_cases(kSmall, 4, 2000); }
TEST(PriorityProcessorRtl, AgreesOnEveryPinAtASizeThatIsNoPowerOfTwo) {
  random_cases(kOdd, 3, 3000);
}

// What registers without reset begin with does not matter.
TEST(PriorityProcessorRtl, AgreesWhateverTheRegistersBeginWith) {
  test::fresh_simulation();
  const test::PriorityRandomCase c(7, {kSmall.members, kSmall.levels});
  LockStep lock_step;
  for (std::uint32_t seed = 1; seed <= 30; ++seed) lock_step.add(c.bench, kSmall, 1u << seed);
  lock_step.run(500'000);
}

// A larger size is an exact stand-in for a smaller one.
TEST(PriorityProcessorRtl, SizesAgree) {
  test::fresh_simulation();
  std::deque<test::PriorityRandomCase> cases;
  LockStep lock_step;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    cases.emplace_back(seed, test::PriorityLimits{kOdd.members, kOdd.levels});
    for (const Size size : {kShipped, kSmall, kOdd}) lock_step.add(cases.back().bench, size, 1);
  }
  lock_step.run(500'000);
}

TEST(PriorityProcessorRtl, AgreesOnPreparedWorlds) {
  test::fresh_simulation();
  std::deque<test::PriorityWorldCase> cases;
  LockStep lock_step;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    lock_step.add(cases.emplace_back(seed).bench, kShipped, static_cast<std::uint32_t>(seed));
  lock_step.run(3'000'000);
}

// Where the lowest bits decide: the eye on a plane, and a unit of its word off it.
TEST(PriorityProcessorRtl, AgreesWhereTheEyeIsNextToAPlane) {
  test::fresh_simulation();
  Random random(11);
  std::deque<PriorityCase> cases;
  LockStep lock_step;
  std::size_t firsts[2] = {0, 0};
  for (int n = 0; n < 30; ++n) {
    const auto whole = [&] { return std::ldexp(static_cast<int>(random.below(1 << 28)), -20); };
    const Vec3 point{whole(), -whole(), whole()};
    const Vec3 normal{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    for (const double off : {-0x1p-20, 0.0, 0x1p-20}) {
      cases.push_back(
          test::table_case(2, {{normal, point, {{1, 0}}}}, {point.x + off, point.y, point.z}));
      lock_step.add(cases.back(), kSmall, 1);
    }
  }
  lock_step.run(10'000);
  for (std::size_t i = 0; i < lock_step.cases(); ++i)
    ++firsts[lock_step.rtl(i).history.at(0).word.item];
  EXPECT_GT(firsts[0], 20u);
  EXPECT_GT(firsts[1], 20u);
}

// Counters of all members up to 63, and beyond; a table of the same pairs again and again.
TEST(PriorityProcessorRtl, CountersOfAllMembersSaturate) {
  test::fresh_simulation();
  std::deque<PriorityCase> cases;
  LockStep lock_step;
  for (std::uint8_t member = 0; member < 8; ++member)
    for (const std::size_t pairs : {63u, 64u, 70u}) {
      const std::uint8_t other = (member + 1) % 8;
      cases.push_back(test::table_case(
          8, {{kX, {10, 0, 0}, std::vector<MemberPair>(pairs, {member, other})}}, {}));
      lock_step.add(cases.back(), kSmall, 1);
    }
  lock_step.run(20'000);
}

/// Groups below each other, each of `members`, one of which is the next group.
PriorityCase deep_case(std::uint32_t members, std::uint32_t levels) {
  PriorityHierarchy h;
  ActiveEnvironment active;
  std::uint32_t items = 0;
  for (std::uint32_t g = 0; g < levels; ++g) {
    h.groups.push_back({g * members, members, 0, 0});
    for (std::uint32_t m = 0; m < members; ++m) {
      const bool is_group = m == 5 && g + 1 < levels;
      h.members.push_back({is_group, is_group ? g + 1 : items++, {}});
    }
    active.groups.push_back({g, ~std::uint64_t{0} >> (64 - members), g + 1});
  }
  PriorityCase c;
  c.frames = 1;
  c.memories.push_back(std::make_unique<PriorityMemory>(h, items, 0, c.machine));
  c.filled.assign(2, PriorityBank(*c.memories[0]));
  for (PriorityBank& bank : c.filled) bank.fill(active, {}, 0);
  return c;
}

// Large groups on all levels: places up to 63 and 64.
TEST(PriorityProcessorRtl, LargeGroupsBelowEachOther) {
  test::fresh_simulation();
  std::deque<PriorityCase> cases;
  LockStep lock_step;
  for (const Size size : {kShipped, Size{64, 4}})
    for (const std::uint32_t members : {63u, 64u}) {
      cases.push_back(deep_case(members, 4));
      lock_step.add(cases.back(), size, 1);
    }
  lock_step.run(200'000);
}

/// The list that the RTL makes, a digit an item, and '!' after it for a fault.
std::vector<std::string> tables(const std::deque<PriorityCase>& cases) {
  LockStep lock_step;
  for (const PriorityCase& c : cases) lock_step.add(c, kSmall, 1);
  lock_step.run(10'000);
  std::vector<std::string> lists;
  for (std::size_t i = 0; i < lock_step.cases(); ++i) {
    std::string& list = lists.emplace_back();
    for (const auto& h : lock_step.rtl(i).history)
      if (!h.word.end) list += static_cast<char>('0' + h.word.item);
    if (!lock_step.rtl(i).figures.at(0).faults.empty()) list += '!';
  }
  return lists;
}

using Lists = std::vector<std::string>;

TEST(StumpThroughTheRtl, Fig7AndItsFault) {
  test::fresh_simulation();
  std::deque<PriorityCase> cases;
  for (long n = 1; n <= 3; ++n)
    cases.push_back(test::table_case(4, {kFig7.begin(), kFig7.begin() + n}, {}));
  cases.push_back(test::table_case(4, kFig7Reassigned, {}));
  EXPECT_EQ(tables(cases), (Lists{"0123!", "0132!", "0123!", "0123"}));
}

TEST(StumpThroughTheRtl, TestCase1) {
  test::fresh_simulation();
  std::deque<PriorityCase> cases;
  for (const double x : {11.0, 10.0, 9.0})
    cases.push_back(test::table_case(2, kTestCase1, {x, 3, 4}));
  EXPECT_EQ(tables(cases), (Lists{"10", "10", "01"}));
}

TEST(StumpThroughTheRtl, TestCase2InItsFourRegions) {
  test::fresh_simulation();
  std::deque<PriorityCase> cases;
  for (const Vec3& eye : {Vec3{50, 0, 0}, Vec3{0, 0, 0}, Vec3{70, 0, 0}, Vec3{70, -70, 0}})
    cases.push_back(test::table_case(4, kTestCase2, eye));
  EXPECT_EQ(tables(cases), (Lists{"3210", "2301", "1032", "0123"}));
}

// The list is the inverse of the counts that the report gives for the nine regions.
TEST(StumpThroughTheRtl, TestCase3InItsNineRegions) {
  test::fresh_simulation();
  std::deque<PriorityCase> cases;
  for (const double x : {5.0, 20.0, 30.0})
    for (const double y : {5.0, 20.0, 30.0})
      cases.push_back(test::table_case(5, kTestCase3, {x, y, 0}));
  Lists expected;
  for (const std::string counts :
       {"01234", "10234", "12034", "21034", "21304", "23140", "32104", "32140", "43210"}) {
    std::string& list = expected.emplace_back(5, ' ');
    for (std::size_t object = 0; object < 5; ++object)
      list[static_cast<std::size_t>(counts[object] - '0')] = static_cast<char>('0' + object);
  }
  std::sort(expected.begin(), expected.end());
  Lists lists = tables(cases);
  std::sort(lists.begin(), lists.end());
  EXPECT_EQ(lists, expected);
}

/// What ends the simulation of a group, or of groups below each other, on the small size.
std::string fault(std::uint32_t members, std::uint32_t levels) {
  PriorityHierarchy h;
  for (std::uint32_t g = 0; g < levels; ++g) {
    h.groups.push_back({g, 1, 0, 0});
    h.members.push_back({g + 1 < levels, g + 1 < levels ? g + 1 : 0, {}});
  }
  for (std::uint32_t m = 1; m < members; ++m) h.members.push_back({false, m, {}});
  if (members > 1) h.groups[0].member_count = members;
  PriorityCase c;
  c.frames = 1;
  c.memories.push_back(std::make_unique<PriorityMemory>(h, members, 0, c.machine));
  ActiveEnvironment active;
  for (std::uint32_t g = 0; g < levels; ++g)
    active.groups.push_back({g, (std::uint64_t{1} << h.groups[g].member_count) - 1, g + 1});
  c.filled.assign(2, PriorityBank(*c.memories[0]));
  c.filled[0].fill(active, {}, 0);
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::deque<PriorityBench> benches;
  benches.emplace_back(c, library(kSmall), 1, clock);
  try {
    test::run_benches(clock, benches, 10'000);
  } catch (const std::exception& error) {
    return error.what();
  }
  return benches[0].done() ? "" : "not done";
}

TEST(PriorityProcessorRtl, WhatIsTooLargeForItsSizeEndsTheSimulation) {
  EXPECT_EQ(fault(8, 1), "");
  EXPECT_EQ(fault(1, 4), "");
  EXPECT_NE(fault(9, 1).find("a contract of the RTL is broken"), std::string::npos);
  EXPECT_NE(fault(1, 5).find("a contract of the RTL is broken"), std::string::npos);
}

}  // namespace
}  // namespace cigsim::priority_processor
