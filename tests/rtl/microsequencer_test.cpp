// SPDX-License-Identifier: MIT
// The microsequencer's RTL against firmware::Sequencer, the same vectors under Verilator and under
// Icarus: all sixteen instructions with the counter zero and not, the condition passing and
// failing, and the stack from empty to overfull.
#include <gtest/gtest.h>

#include <map>

#include "firmware/sequencer.hpp"
#include "models/boundary/rtl_model.hpp"
#include "models/environment/random.hpp"
#include "rtl/common/microsequencer.pins.hpp"
#include "tests/rtl/icarus.hpp"

namespace cigsim {
namespace {

using firmware::Sequencer;
using firmware::SequencerOp;

struct Step {
  bool reset = false;
  SequencerOp op = SequencerOp::kCont;
  bool pass = false;
  std::uint16_t d = 0;
};
struct State {
  std::uint16_t address, counter, top;
  unsigned level;
  friend bool operator==(const State&, const State&) = default;
};
void PrintTo(const State& s, std::ostream* out) {
  *out << "address " << s.address << " counter " << s.counter << " top " << s.top << " level "
       << s.level;
}

/// Steps after a reset, which now and then come again.
std::vector<Step> random_steps(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Step> steps{{true}, {true}};
  std::uint32_t bias = 0;
  for (int n = 0; n < count; ++n) {
    if (n % 50 == 0) bias = random.below(3);  // nothing, pushes, counted loops
    Step step;
    step.reset = random.below(200) == 0;
    step.op = static_cast<SequencerOp>(random.below(16));
    if (random.below(2) && bias == 1)
      step.op = random.below(2) ? SequencerOp::kPush : SequencerOp::kCjs;
    if (random.below(2) && bias == 2)
      step.op = random.below(2) ? SequencerOp::kTwb : SequencerOp::kRfct;
    if (step.op == SequencerOp::kJz && random.below(4)) step.op = SequencerOp::kLdct;
    step.pass = random.below(2);
    step.d = static_cast<std::uint16_t>(random.below(random.below(2) ? 4 : 4096));
    steps.push_back(step);
  }
  return steps;
}

/// The state in which each step is done; the first one is not defined.
std::vector<State> by_the_model(const std::vector<Step>& steps) {
  Sequencer s;
  std::vector<State> states;
  for (const Step& step : steps) {
    states.push_back({s.address(), s.counter(), s.stack_top(), s.stack_level()});
    if (step.reset)
      s.reset();
    else
      s.step(step.op, step.pass, step.d);
  }
  return states;
}

TEST(MicrosequencerRtl, VectorsMeetEveryCase) {
  const auto steps = random_steps(1, 20'000);
  const auto states = by_the_model(steps);
  std::map<int, int> met;
  for (std::size_t n = 0; n < steps.size(); ++n) {
    if (steps[n].reset) continue;
    const int level = states[n].level == 0 ? 0 : states[n].level == firmware::kStackDepth ? 2 : 1;
    ++met[static_cast<int>(steps[n].op) * 12 + steps[n].pass * 6 + (states[n].counter != 0) * 3 +
          level];
  }
  EXPECT_EQ(met.size(), 16u * 12) << "instruction, condition, counter, stack";
}

TEST(MicrosequencerRtl, AgreesWithTheModelUnderVerilator) {
  using rtl::microsequencer::Pins;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto steps = random_steps(seed, 20'000);
    const auto states = by_the_model(steps);
    RtlModel model(CIGSIM_RTL_LIBRARIES "/microsequencer-StackDepth=5.so", sizeof(Pins),
                   static_cast<std::uint32_t>(seed));
    Pins& pins = model.pins<Pins>();
    model.settle();
    for (std::size_t n = 0; n < steps.size(); ++n) {
      if (n > 1) {
        const State got{pins.micro_address_o, pins.counter_o, pins.stack_top_o, pins.stack_level_o};
        ASSERT_EQ(got, states[n]) << "step " << n;
      }
      pins.rst_i = steps[n].reset;
      pins.op_i = static_cast<std::uint8_t>(steps[n].op);
      pins.pass_i = steps[n].pass;
      pins.d_i = steps[n].d;
      model.edge();
    }
  }
}

TEST(MicrosequencerRtl, AgreesWithTheModelUnderIcarus) {
  if (!test::has_icarus()) GTEST_SKIP() << "Icarus Verilog (iverilog) is not installed";
  const auto steps = random_steps(1, 20'000);
  const auto states = by_the_model(steps);
  std::vector<std::vector<std::uint64_t>> rows;
  for (const Step& step : steps)
    rows.push_back({step.reset, static_cast<std::uint64_t>(step.op), step.pass, step.d});
  const auto outputs = test::run_icarus(
      {"microsequencer",
       {"common/microsequencer.sv"},
       {{"rst_i", 1}, {"op_i", 4}, {"pass_i", 1}, {"d_i", 12}},
       {{"micro_address_o", 12}, {"counter_o", 12}, {"stack_top_o", 12}, {"stack_level_o", 3}},
       {}},
      rows);
  for (std::size_t n = 1; n < steps.size(); ++n) {
    const auto& out = outputs[n];
    ASSERT_TRUE(out[0] && out[1] && out[2] && out[3]) << "unknown after step " << n;
    const State got{static_cast<std::uint16_t>(*out[0]), static_cast<std::uint16_t>(*out[1]),
                    static_cast<std::uint16_t>(*out[2]), static_cast<unsigned>(*out[3])};
    ASSERT_EQ(got, states[n]) << "step " << n;
  }
}

}  // namespace
}  // namespace cigsim
