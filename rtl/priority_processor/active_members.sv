// SPDX-License-Identifier: MIT
// The members of a group that are in view, and those of them that are not yet listed, with an
// encoder of the first one. Members that are groups have their records one after the other in the
// bank, so the record of the next such member is counted along. Reconstruction (docs/machine/
// priority_processor.md).
`include "rtl/common/assertions.svh"

module active_members #(
    parameter int Members = 64,  // 2 to 64
    localparam int MemberWidth = $clog2(Members)
) (
    input  logic                   clk_i,
    input  logic                   rst_i,
    input  logic                   load_low_i,      // members 0 to 31 from the word
    input  logic                   load_high_i,     // members 32 to 63
    input  logic                   load_child_i,    // record of the first member that is a group
    input  logic                   rest_load_i,     // all active members are to be listed
    input  logic                   rest_next_i,     // the first one of rest is listed
    input  logic [           31:0] word_i,          // with rest_next_i its member word
    output logic [    Members-1:0] active_o,
    output logic                   many_o,          // two are active at least
    output logic                   any_left_o,
    output logic [MemberWidth-1:0] first_left_o,    // 0 when none is left
    output logic [           31:0] entry_o          // an item, or bit 31 and the group's record
);
  localparam int RecordWords = 4;

  logic [63:0] loaded;
  logic [Members-1:0] mask_q;
  always_comb begin
    loaded = '0;
    loaded[Members-1:0] = mask_q;
    if (load_low_i) loaded[31:0] = word_i;
    if (load_high_i) loaded[63:32] = word_i;
  end
  always_ff @(posedge clk_i) mask_q <= loaded[Members-1:0];

  logic [31:0] child_q;
  always_ff @(posedge clk_i) if (load_child_i) child_q <= word_i;

  logic [Members-1:0] rest_q;
  logic [31:0] next_child_q;
  always_ff @(posedge clk_i) begin
    if (rest_load_i) begin
      rest_q <= mask_q;
      next_child_q <= child_q;
    end else if (rest_next_i) begin
      rest_q <= rest_q & (rest_q - 1'b1);
      if (word_i[31]) next_child_q <= next_child_q + 32'(RecordWords);
    end
  end

  first_set #(
      .Width(Members)
  ) first (
      .bits_i (rest_q),
      .any_o  (any_left_o),
      .index_o(first_left_o)
  );

  assign active_o = mask_q;
  assign many_o = (mask_q & (mask_q - 1'b1)) != '0;
  assign entry_o = word_i[31] ? {1'b1, next_child_q[30:0]} : word_i;

  `CIGSIM_ASSERT(members_exist, !(load_low_i || load_high_i) || (loaded >> Members) == '0)
  `CIGSIM_ASSERT(left_are_active, !rest_next_i || (any_left_o && (rest_q & ~mask_q) == '0))
endmodule
