// SPDX-License-Identifier: MIT
// The whole edge orderer under Icarus and under Verilator, on the same inputs: every output in
// every cycle. That these outputs are right is the business of tests/levels.
#include <gtest/gtest.h>

#include "models/boundary/rtl_model.hpp"
#include "rtl/edge_orderer/edge_orderer.pins.hpp"
#include "tests/levels/orderer_case.hpp"
#include "tests/rtl/icarus.hpp"

namespace cigsim {
namespace {

using rtl::edge_orderer::Pins;
using Rows = std::vector<std::vector<std::uint64_t>>;

const std::vector<test::IcarusPort> kInputs{{"rst_i", 1},
                                            {"cfg_width_i", 14},
                                            {"cfg_height_i", 14},
                                            {"cfg_policy_i", 2},
                                            {"edges_valid_i", 1},
                                            {"edges_face_i", 24},
                                            {"edges_left_i", 1},
                                            {"edges_first_line_i", 14},
                                            {"edges_end_line_i", 14},
                                            {"edges_end_i", 1},
                                            {"edges_x_i", 32},
                                            {"edges_slope_i", 32},
                                            {"loaded_ready_i", 1},
                                            {"start_valid_i", 1},
                                            {"start_frame_i", 32},
                                            {"crossings_ready_i", 1},
                                            {"cfg_crossing_capacity_i", 32}};
const std::vector<test::IcarusPort> kOutputs{
    {"edges_ready_o", 1},     {"loaded_valid_o", 1},       {"loaded_frame_o", 32},
    {"start_ready_o", 1},     {"crossings_valid_o", 1},    {"mon_pass_o", 1},
    {"mon_line_o", 1},        {"mon_too_small_o", 1},      {"mon_overfull_o", 1},
    {"crossings_face_o", 24}, {"crossings_element_o", 14}, {"crossings_left_o", 1},
    {"crossings_end_o", 1},   {"crossings_cut_o", 1},      {"mon_crossings_o", 32},
    {"mon_dropped_o", 32},    {"mon_overflow_o", 1}};
/// Of these; the others tell something only while one of these is high, or an edge is stepped.
constexpr std::size_t kAlwaysKnown = 9;
constexpr std::size_t kReset = 2;  ///< rows

/// Inputs of a run, and the outputs under them by Verilator.
struct Recording {
  Rows inputs, outputs;
  std::size_t frames = 0;  ///< that were drained
};

Recording verilated(const test::OrdererCase& c, unsigned seed) {
  std::mt19937 random(seed);
  const bool pauses = random() % 2 == 0;
  const auto may = [&] { return !pauses || random() % 3 != 0; };
  RtlModel model(CIGSIM_RTL_LIBRARIES "/edge_orderer-Edges=100-Lines=16-Crossings=16.so",
                 sizeof(Pins), seed);
  Pins& pins = model.pins<Pins>();
  Recording run;
  const auto step = [&] {
    model.settle();
    run.inputs.push_back({pins.rst_i, pins.cfg_width_i, pins.cfg_height_i, pins.cfg_policy_i,
                          pins.edges_valid_i, pins.edges_face_i, pins.edges_left_i,
                          pins.edges_first_line_i, pins.edges_end_line_i, pins.edges_end_i,
                          pins.edges_x_i, pins.edges_slope_i, pins.loaded_ready_i,
                          pins.start_valid_i, pins.start_frame_i, pins.crossings_ready_i,
                          pins.cfg_crossing_capacity_i});
    run.outputs.push_back({pins.edges_ready_o, pins.loaded_valid_o, pins.loaded_frame_o,
                           pins.start_ready_o, pins.crossings_valid_o, pins.mon_pass_o,
                           pins.mon_line_o, pins.mon_too_small_o, pins.mon_overfull_o,
                           pins.crossings_face_o, pins.crossings_element_o, pins.crossings_left_o,
                           pins.crossings_end_o, pins.crossings_cut_o, pins.mon_crossings_o,
                           pins.mon_dropped_o, pins.mon_overflow_o});
    model.edge();
  };
  pins.cfg_width_i = static_cast<std::uint16_t>(c.machine.raster.width);
  pins.cfg_height_i = static_cast<std::uint16_t>(c.machine.raster.height);
  pins.cfg_crossing_capacity_i = c.machine.crossing_capacity;
  pins.cfg_policy_i = static_cast<std::uint8_t>(c.policy);
  pins.rst_i = true;
  for (std::size_t row = 0; row < kReset; ++row) step();
  pins.rst_i = false;

  std::size_t given = 0, loaded = 0, started = 0, edge = 0;  // pictures; edges of the given one
  for (int lines = 0; run.frames < c.frames.size() && run.inputs.size() < 10'000;) {
    // The edges of a picture come when the one before has started.
    if (!pins.edges_valid_i && given < c.frames.size() && given <= started && may()) {
      const bool end = edge == c.frames[given].size();
      const EdgeWord word = end ? EdgeWord{} : c.frames[given][edge];
      pins.edges_valid_i = true;
      pins.edges_face_i = word.face;
      pins.edges_left_i = word.left;
      pins.edges_first_line_i = word.first_line;
      pins.edges_end_line_i = word.end_line;
      pins.edges_end_i = end;
      pins.edges_x_i = static_cast<std::uint32_t>(word.x);
      pins.edges_slope_i = static_cast<std::uint32_t>(word.slope);
    }
    pins.loaded_ready_i = may();
    pins.start_valid_i = pins.start_valid_i || (started < loaded && may());
    pins.start_frame_i = static_cast<std::uint32_t>(started);
    pins.crossings_ready_i = may();

    const bool edge_taken = pins.edges_valid_i && pins.edges_ready_o;
    const bool loaded_taken = pins.loaded_valid_o && pins.loaded_ready_i;
    const bool start_taken = pins.start_valid_i && pins.start_ready_o;
    lines += pins.crossings_valid_o && pins.crossings_ready_i && pins.crossings_end_o;
    step();
    if (edge_taken) {
      pins.edges_valid_i = false;
      ++edge;
      if (pins.edges_end_i) {
        ++given;
        edge = 0;
      }
    }
    loaded += loaded_taken;
    if (start_taken) {
      pins.start_valid_i = false;
      ++started;
    }
    if (lines == c.machine.raster.height) {
      lines = 0;
      ++run.frames;
    }
  }
  return run;
}

TEST(EdgeOrdererIcarus, EveryOutputIsThatOfVerilatorInEveryCycle) {
  if (!test::has_icarus()) GTEST_SKIP() << "Icarus Verilog (iverilog) is not installed";
  for (unsigned seed = 1, cases = 0; cases < 12; ++seed) {
    const test::OrdererCase c(seed);
    if (c.machine.crossing_capacity == 0) continue;
    ++cases;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Recording run = verilated(c, seed);
    ASSERT_EQ(run.frames, c.frames.size());
    const auto outputs =
        test::run_icarus({"edge_orderer",
                          {"common/first_set.sv", "edge_orderer/active_list.sv",
                           "edge_orderer/bucket_memory.sv", "edge_orderer/edge_memory.sv",
                           "edge_orderer/edge_orderer.sv", "edge_orderer/edge_stepper.sv",
                           "edge_orderer/line_overload.sv", "edge_orderer/sorting_memory.sv"},
                          kInputs,
                          kOutputs,
                          {"Edges(100)", "Lines(16)", "Crossings(16)"}},
                         run.inputs);
    for (std::size_t row = kReset; row < run.inputs.size(); ++row) {
      const bool offered = run.outputs[row][4] != 0;
      for (std::size_t pin = 0; pin < kOutputs.size(); ++pin) {
        const bool known = pin < kAlwaysKnown || (offered && pin < kAlwaysKnown + 5);
        if (!known && !outputs[row][pin]) continue;
        ASSERT_EQ(outputs[row][pin], run.outputs[row][pin])
            << kOutputs[pin].name << " in cycle " << row - kReset;
      }
    }
  }
}

}  // namespace
}  // namespace cigsim
