// SPDX-License-Identifier: MIT
// Gates, packages and delays: a netlist worked out by hand, and circuits so small that their gates
// are known.
#include <gtest/gtest.h>

#include "sim/gates/netlist.hpp"
#include "sim/gates/ordering.hpp"
#include "sim/gates/parts.hpp"
#include "sim/gates/synthesis.hpp"

namespace cigsim::gates {
namespace {

// a and b, the first of them inverted, go to a module `inner` of a NAND and a XOR behind it; its
// answer is kept in a flip-flop, which addresses a RAM of 20 x 6 bits that is read in one place.
constexpr const char* kByHand = R"({"modules": {
  "inner": {"attributes": {}, "ports": {
      "x": {"direction": "input", "bits": [2]}, "y": {"direction": "input", "bits": [3]},
      "z": {"direction": "output", "bits": [5]}},
    "cells": {
      "n": {"type": "NAND2", "connections": {"A": [2], "B": [3], "Y": [4]}},
      "o": {"type": "XOR2", "connections": {"A": [4], "B": ["1"], "Y": [5]}}}},
  "top": {"attributes": {}, "ports": {
      "clk": {"direction": "input", "bits": [9]}, "a": {"direction": "input", "bits": [2]},
      "b": {"direction": "input", "bits": [3]}, "c": {"direction": "output", "bits": [7, "0"]}},
    "cells": {
      "i": {"type": "INV", "connections": {"A": [2], "Y": [4]}},
      "u": {"type": "inner", "connections": {"x": [4], "y": [3], "z": [5]}},
      "f": {"type": "$_DFF_P_", "connections": {"C": [9], "D": [5], "Q": [6]}},
      "m": {"type": "$mem_v2",
        "parameters": {"WIDTH": "110", "SIZE": "10100", "RD_PORTS": "1", "RD_CLK_ENABLE": "0"},
        "connections": {"RD_ADDR": [6, "0", "0", "0", "0"], "RD_DATA": [10, 11, 12, 13, 14, 15],
          "WR_ADDR": [6, "0", "0", "0", "0"], "WR_DATA": [3, 3, 3, 3, 3, 3], "WR_EN": [2]}},
      "j": {"type": "INV", "connections": {"A": [12], "Y": [7]}}}}}})";

TEST(Gates, NetlistIsCountedAsByHand) {
  const Netlist netlist(kByHand);
  const Inventory top = netlist.inventory("top");
  EXPECT_EQ(top.gates, (decltype(top.gates){{"INV", 2}, {"NAND2", 1}, {"XOR2", 1}}));
  EXPECT_EQ(top.gate_count(), 4u);
  EXPECT_EQ(top.flip_flops, 1u);
  EXPECT_EQ(top.ram_bits, 120u);
  EXPECT_EQ(top.ram_packages, 4u);  // two beside each other, two above each other
  EXPECT_EQ(top.packages(), 3u + 1u + 4u);
  EXPECT_EQ(netlist.inventory("inner").gate_count(), 2u);
}

TEST(Gates, LongestWayIsThatByHand) {
  const Netlist netlist(kByHand);
  EXPECT_EQ(netlist.longest_way("inner", {}), 3);          // NAND, and XOR for two
  EXPECT_EQ(netlist.longest_way("top", {}), 4);            // from a to the flip-flop
  EXPECT_EQ(netlist.longest_way("top", {3, 35}), 35 + 3);  // from the flip-flop to c
  EXPECT_EQ(netlist.longest_way("top", {10, 5}), 4 * 10);
}

TEST(Gates, WhatIsNoNetlistOfPartsIsNamed) {
  EXPECT_THROW(Netlist("{}"), std::runtime_error);
  EXPECT_THROW(Netlist("no JSON"), std::runtime_error);
  EXPECT_THROW(Netlist(R"({"modules": {"m": {"attributes": {}, "ports": {},
      "cells": {"l": {"type": "$_LATCH_P_", "connections": {}}}}}})"),
               std::runtime_error);
  EXPECT_THROW(Netlist(kByHand).inventory("none"), std::runtime_error);
  const Netlist loop(R"({"modules": {"m": {"attributes": {},
      "ports": {"o": {"direction": "output", "bits": [2]}},
      "cells": {"l": {"type": "INV", "connections": {"A": [2], "Y": [2]}}}}}})");
  EXPECT_THROW(loop.longest_way("m", {}), std::runtime_error);
}

// Any: an OR. Index: the second and not the first, an inverter and one gate.
TEST(Gates, EncoderOfTwoBitsIsThreeGates) {
  const Netlist netlist = Synthesis().map({"common", "first_set", {{"Width", 2}}});
  EXPECT_EQ(netlist.inventory("first_set").gate_count(), 3u);
  EXPECT_EQ(netlist.inventory("first_set").flip_flops, 0u);
  EXPECT_EQ(netlist.longest_way("first_set", {}), 2);
}

// By hand: an OR of four, b0' (b1 + b2' b3) and b0' b1' (b2 + b3), 12 gates of one and two inputs.
TEST(Gates, EncoderOfFourBitsIsFewGates) {
  const Netlist netlist = Synthesis().map({"common", "first_set", {{"Width", 4}}});
  EXPECT_GE(netlist.inventory("first_set").gate_count(), 5u);
  EXPECT_LE(netlist.inventory("first_set").gate_count(), 12u);
  EXPECT_GE(netlist.longest_way("first_set", {}), 2);
  EXPECT_LE(netlist.longest_way("first_set", {}), 4);
}

TEST(Gates, MoreBitsTakeMoreGatesAndNoFewerLevels) {
  const Synthesis synthesis;
  std::uint64_t gates = 0;
  double levels = 0;
  for (const std::uint32_t planes : {1u, 2u, 4u, 8u, 16u, 32u}) {
    const Netlist netlist =
        synthesis.map({"priority_processor", "so_pair", {{"Planes", planes}}, true});
    EXPECT_GT(netlist.inventory("so_pair").gate_count(), gates) << planes;
    EXPECT_GE(netlist.longest_way("so_pair", {}), levels) << planes;
    gates = netlist.inventory("so_pair").gate_count();
    levels = netlist.longest_way("so_pair", {});
  }
}

TEST(Gates, MatrixIsItsRowsAndARowItsPairs) {
  const Netlist netlist =
      Synthesis().map({"priority_processor", "so_matrix", {{"Objects", 5}, {"Planes", 4}}, true});
  const std::uint64_t pair = netlist.inventory("so_pair").gate_count(),
                      row = netlist.inventory("so_row").gate_count();
  EXPECT_EQ(row, 5 * pair + 3 * 5);  // each answer is asked for
  EXPECT_EQ(netlist.inventory("so_matrix").gate_count(), 5 * row);
  EXPECT_EQ(netlist.longest_way("so_matrix", {}), netlist.longest_way("so_row", {}));
}

TEST(Gates, MemoriesOfTheActiveSetAreRams) {
  const Inventory set =
      Synthesis().map({"priority_resolver", "active_set", {{"Faces", 64}}}).inventory("active_set");
  EXPECT_EQ(set.ram_bits, 2 * 64u);
  EXPECT_EQ(set.flip_flops, 4u);        // two words: written, and with an active face
  EXPECT_EQ(set.ram_packages, 8 * 3u);  // the active bits are read in two places
}

TEST(Gates, PartsHaveDistinctNamesAndAShareOfAPackage) {
  for (const Part& part : parts()) {
    EXPECT_EQ(find_part(part.name), &part);
    EXPECT_NE(genlib().find("GATE " + std::string(part.name) + " "), std::string::npos);
    EXPECT_EQ(12 % part.per_package, 0) << part.name;
  }
}

// n (n - 1) / 2 <= 260 up to n = 23; rows of 64 go twice over 128 objects; 16 matrices of 64 x 64
// stand beside each other.
TEST(Gates, ObjectsInALineAreThoseByHand) {
  EXPECT_EQ(objects_in(Way::kPair, 260, 64), 23u);
  EXPECT_EQ(objects_in(Way::kRow, 260, 64), 128u);
  EXPECT_EQ(objects_in(Way::kMatrix, 260, 64), 1024u);
  EXPECT_EQ(objects_in(Way::kRow, 260, 256), 256u);
  EXPECT_EQ(objects_in(Way::kPair, 0, 64), 0u);
}

TEST(Gates, OneObjectMoreNeedsMoreSteps) {
  for (const Way way : {Way::kPair, Way::kRow, Way::kMatrix})
    for (std::uint64_t width : {1u, 2u, 5u, 64u})
      for (std::uint64_t steps = 1; steps < 500; steps += 7) {
        const std::uint64_t objects = objects_in(way, steps, width);
        EXPECT_LE(steps_for(way, objects, width), steps);
        EXPECT_GT(steps_for(way, objects + 1, width), steps);
      }
}

}  // namespace
}  // namespace cigsim::gates
