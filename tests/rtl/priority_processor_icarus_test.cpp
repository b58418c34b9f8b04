// SPDX-License-Identifier: MIT
// The whole priority processor under Icarus and under Verilator, on the same inputs: every output
// in every cycle, the microprogram loaded through the pins. That these outputs are right is the
// business of tests/levels.
#include <gtest/gtest.h>

#include "firmware/programs.hpp"
#include "models/boundary/rtl_model.hpp"
#include "rtl/priority_processor/priority_processor.pins.hpp"
#include "tests/levels/priority_random_case.hpp"
#include "tests/rtl/icarus.hpp"

namespace cigsim {
namespace {

using rtl::priority_processor::Pins;
using Rows = std::vector<std::vector<std::uint64_t>>;

const std::vector<test::IcarusPort> kInputs{{"rst_i", 1},          {"cfg_object_capacity_i", 32},
                                            {"image_write_i", 1},  {"image_address_i", 6},
                                            {"image_word_i", 53},  {"start_valid_i", 1},
                                            {"start_frame_i", 32}, {"items_ready_i", 1},
                                            {"memory_word_i", 32}, {"bank_word_i", 32}};
const std::vector<test::IcarusPort> kOutputs{
    {"start_ready_o", 1},   {"items_valid_o", 1},     {"mon_stalled_o", 1}, {"mon_dropped_o", 1},
    {"mon_group_o", 1},     {"mon_plane_o", 1},       {"mon_pair_o", 1},    {"mon_fault_o", 1},
    {"items_set_o", 2},     {"items_item_o", 30},     {"items_end_o", 1},   {"bank_o", 1},
    {"bank_address_o", 32}, {"memory_address_o", 32}, {"mon_frame_o", 32},  {"mon_record_o", 32}};
/// Of these; the others are registers that nothing sets before the first frame.
constexpr std::size_t kKnownFromReset = 8;

/// Inputs of a run, and the outputs under them by Verilator.
struct Recording {
  Rows inputs, outputs;
  std::size_t reset = 0;  ///< rows
  std::uint32_t ends = 0;
};

Recording verilated(const test::PriorityCase& c, std::uint64_t seed, std::size_t most_rows) {
  const auto banks = c.banks();
  Random random(seed);
  RtlModel model(CIGSIM_RTL_LIBRARIES "/priority_processor-Members=8-Levels=4.so", sizeof(Pins),
                 static_cast<std::uint32_t>(seed));
  Pins& pins = model.pins<Pins>();
  Recording run;
  const auto step = [&] {
    run.inputs.push_back({pins.rst_i, pins.cfg_object_capacity_i, pins.image_write_i,
                          pins.image_address_i, pins.image_word_i, pins.start_valid_i,
                          pins.start_frame_i, pins.items_ready_i, pins.memory_word_i,
                          pins.bank_word_i});
    run.outputs.push_back({pins.start_ready_o, pins.items_valid_o, pins.mon_stalled_o,
                           pins.mon_dropped_o, pins.mon_group_o, pins.mon_plane_o, pins.mon_pair_o,
                           pins.mon_fault_o, pins.items_set_o, pins.items_item_o, pins.items_end_o,
                           pins.bank_o, pins.bank_address_o, pins.memory_address_o,
                           pins.mon_frame_o, pins.mon_record_o});
    model.edge();
  };
  pins = {};
  pins.cfg_object_capacity_i = c.machine.object_capacity;
  pins.rst_i = pins.image_write_i = true;
  model.settle();
  const auto words = firmware::stage_program("priority_processor").words;
  for (std::uint32_t address = 0; address < words.size(); ++address) {
    pins.image_address_i = address;
    pins.image_word_i = words[address].low;
    step();
  }
  pins.image_write_i = false;
  step();
  pins.rst_i = false;
  run.reset = run.inputs.size();
  for (std::uint32_t frame = 0; run.ends < c.frames && run.inputs.size() < most_rows;) {
    const auto& bank = banks[pins.bank_o];
    const auto at = [](const std::vector<std::uint32_t>& memory, std::uint32_t address) {
      return address < memory.size() ? memory[address] : 0;
    };
    pins.memory_word_i = at(bank.memory().words, pins.memory_address_o);
    pins.bank_word_i = at(bank.words(), pins.bank_address_o);
    pins.start_valid_i = frame < c.frames && (pins.start_valid_i || random.below(3) == 0);
    pins.start_frame_i = frame;
    pins.items_ready_i = random.below(4) != 0;
    const bool taken = pins.start_valid_i && pins.start_ready_o;
    run.ends += pins.items_valid_o && pins.items_ready_i && pins.items_end_o;
    step();
    if (taken) {
      ++frame;
      pins.start_valid_i = false;
    }
  }
  return run;
}

TEST(PriorityProcessorIcarus, EveryOutputIsThatOfVerilatorInEveryCycle) {
  if (!test::has_icarus()) GTEST_SKIP() << "Icarus Verilog (iverilog) is not installed";
  std::uint32_t ends = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const test::PriorityRandomCase c(seed, {8, 4});
    const Recording run = verilated(c.bench, seed, 20'000);
    ends += run.ends;
    const auto outputs = test::run_icarus(
        {"priority_processor",
         {"common/first_set.sv", "common/microsequencer.sv", "priority_processor/active_members.sv",
          "priority_processor/control_store.sv", "priority_processor/group_places.sv",
          "priority_processor/item_output.sv", "priority_processor/object_counters.sv",
          "priority_processor/plane_side.sv", "priority_processor/priority_processor.sv"},
         kInputs,
         kOutputs,
         {"Members(8)", "Levels(4)"}},
        run.inputs);
    for (std::size_t row = run.reset; row < run.inputs.size(); ++row)
      for (std::size_t pin = 0; pin < kOutputs.size(); ++pin) {
        if (pin >= kKnownFromReset && !outputs[row][pin]) continue;
        ASSERT_EQ(outputs[row][pin], run.outputs[row][pin])
            << kOutputs[pin].name << " in cycle " << row - run.reset;
      }
    for (std::size_t pin = 0; pin < kOutputs.size(); ++pin)
      EXPECT_TRUE(outputs.back()[pin]) << kOutputs[pin].name << " is known in the end";
  }
  EXPECT_GT(ends, 15u);
}

}  // namespace
}  // namespace cigsim
