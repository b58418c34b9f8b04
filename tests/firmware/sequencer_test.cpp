// SPDX-License-Identifier: MIT
// The microsequencer against the instruction table of the Am2910, as published: for each of the
// sixteen instructions what becomes of address, stack and counter, with the counter zero and not,
// and the condition failing and passing.
#include "firmware/sequencer.hpp"

#include <gtest/gtest.h>

namespace cigsim::firmware {
namespace {

// The letters of the published table. Next address: 0, D, F (stack), P (program counter),
// R (register). Stack: H holds, C clears, U pushes, O pops. Counter: H holds, L loads, D counts.
struct Row {
  SequencerOp op;
  bool counter_zero;
  const char* fail;  // address, stack, counter
  const char* pass;
};

using enum SequencerOp;
constexpr Row kTable[] = {
    {kJz, false, "0CH", "0CH"},   {kJz, true, "0CH", "0CH"},    {kCjs, false, "PHH", "DUH"},
    {kCjs, true, "PHH", "DUH"},   {kJmap, false, "DHH", "DHH"}, {kJmap, true, "DHH", "DHH"},
    {kCjp, false, "PHH", "DHH"},  {kCjp, true, "PHH", "DHH"},   {kPush, false, "PUH", "PUL"},
    {kPush, true, "PUH", "PUL"},  {kJsrp, false, "RUH", "DUH"}, {kJsrp, true, "RUH", "DUH"},
    {kCjv, false, "PHH", "DHH"},  {kCjv, true, "PHH", "DHH"},   {kJrp, false, "RHH", "DHH"},
    {kJrp, true, "RHH", "DHH"},   {kRfct, false, "FHD", "FHD"}, {kRfct, true, "POH", "POH"},
    {kRpct, false, "DHD", "DHD"}, {kRpct, true, "PHH", "PHH"},  {kCrtn, false, "PHH", "FOH"},
    {kCrtn, true, "PHH", "FOH"},  {kCjpp, false, "PHH", "DOH"}, {kCjpp, true, "PHH", "DOH"},
    {kLdct, false, "PHL", "PHL"}, {kLdct, true, "PHL", "PHL"},  {kLoop, false, "FHH", "POH"},
    {kLoop, true, "FHH", "POH"},  {kCont, false, "PHH", "PHH"}, {kCont, true, "PHH", "PHH"},
    {kTwb, false, "FHD", "POD"},  {kTwb, true, "DOH", "POH"},
};

constexpr std::uint16_t kD = 0x123;

// At address 0x400 with two return addresses, the upper 0x201, and the counter 0 or 7.
Sequencer prepared(bool counter_zero) {
  Sequencer s;
  s.step(kCjp, true, 0x100);
  s.step(kCjs, true, 0x200);
  s.step(kCjs, true, 0x300);
  s.step(kLdct, true, counter_zero ? 0 : 7);
  s.step(kCjp, true, 0x400);
  return s;
}

TEST(Sequencer, FollowsTheInstructionTable) {
  for (const Row& row : kTable)
    for (const bool pass : {false, true}) {
      const std::string expected = pass ? row.pass : row.fail;
      SCOPED_TRACE(testing::Message()
                   << "instruction " << static_cast<int>(row.op) << ", counter "
                   << (row.counter_zero ? "zero" : "not zero") << (pass ? ", pass" : ", fail"));
      Sequencer s = prepared(row.counter_zero);
      const std::uint16_t r = s.counter();
      s.step(row.op, pass, kD);
      const std::uint16_t address = expected[0] == '0'   ? 0
                                    : expected[0] == 'D' ? kD
                                    : expected[0] == 'F' ? 0x201
                                    : expected[0] == 'R' ? r
                                                         : 0x401;
      EXPECT_EQ(s.address(), address);
      const unsigned level = expected[1] == 'C'   ? 0
                             : expected[1] == 'U' ? 3
                             : expected[1] == 'O' ? 1
                                                  : 2;
      EXPECT_EQ(s.stack_level(), level);
      if (expected[1] == 'U') {
        EXPECT_EQ(s.stack_top(), 0x401);
      }
      const int counter = expected[2] == 'L' ? kD : expected[2] == 'D' ? r - 1 : r;
      EXPECT_EQ(s.counter(), counter);
    }
}

TEST(Sequencer, ALoopOfCountNIsExecutedNPlusOneTimes) {
  Sequencer s;
  s.step(kLdct, true, 5);
  int times = 0;
  for (; s.address() == 1; ++times) s.step(kRpct, true, 1);
  EXPECT_EQ(times, 6);
}

TEST(Sequencer, TheSixthPushOverwritesTheTop) {
  Sequencer s;
  for (std::uint16_t i = 1; i <= 6; ++i) s.step(kCjs, true, static_cast<std::uint16_t>(i * 16));
  EXPECT_EQ(s.stack_level(), 5u);
  EXPECT_EQ(s.stack_top(), 5 * 16 + 1);
  s.step(kCrtn, true, 0);
  EXPECT_EQ(s.stack_top(), 3 * 16 + 1) << "the fifth return address is lost";
}

TEST(Sequencer, AddressesWrapAtTwelveBits) {
  Sequencer s;
  s.step(kCjp, true, kAddressMask);
  s.step(kCont, true, 0);
  EXPECT_EQ(s.address(), 0);
}

}  // namespace
}  // namespace cigsim::firmware
