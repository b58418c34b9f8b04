// SPDX-License-Identifier: MIT
// Contracts, checked in every cycle of a simulation under Verilator. Icarus 11 and Yosys 0.23 do not
// read concurrent assertions, so that these are clocked checks, and nothing without the macro
// CIGSIM_ASSERTIONS.
//
//   `CIGSIM_ASSERT(name, condition)   the condition holds at each rising clock edge out of reset
// Uses clk_i and rst_i of the module.
`ifndef CIGSIM_ASSERTIONS_SVH
`define CIGSIM_ASSERTIONS_SVH
`ifdef CIGSIM_ASSERTIONS
`define CIGSIM_ASSERT(NAME, CONDITION) \
  always_ff @(posedge clk_i) begin : NAME \
    if (!rst_i && !(CONDITION)) $error("contract broken"); \
  end
`else
`define CIGSIM_ASSERT(NAME, CONDITION)
`endif
`endif
