// SPDX-License-Identifier: MIT
// One step of active_members with 8 members from any values in its registers: masks, the member that
// is listed next, and the records of groups below, four words each ("Bank" in docs/machine/
// priority_processor.md), in all bits.
// registers: mask_q rest_q child_q next_child_q
module active_members_proof #(
    parameter int Members = 8
) (
    input logic        clk_i,
    input logic        second_i,
    input logic        low_i,
    input logic        high_i,
    input logic        child_i,
    input logic [ 1:0] rest_i,    // 1: all are to be listed; 2: one is listed
    input logic [31:0] word_i,

    input logic [ 7:0] mask_q,
    input logic [ 7:0] rest_q,
    input logic [31:0] child_q,
    input logic [31:0] next_child_q,
    output logic       ok_o
);
  logic [7:0] active;
  logic many, any_left;
  logic [2:0] first;
  logic [31:0] entry;
  active_members #(.Members(Members)) dut (
      .clk_i(clk_i), .rst_i(1'b0), .load_low_i(low_i), .load_high_i(high_i),
      .load_child_i(child_i), .rest_load_i(rest_i == 2'd1), .rest_next_i(rest_i == 2'd2),
      .word_i(word_i), .active_o(active), .many_o(many), .any_left_o(any_left),
      .first_left_o(first), .entry_o(entry)
  );

  // The first one that is left, and the others.
  logic [2:0] lowest;
  logic [7:0] others;
  logic [3:0] members;
  always_comb begin
    lowest = 3'd0;
    others = 8'd0;
    members = 4'd0;
    for (int m = 7; m >= 0; m--) begin
      if (rest_q[m]) begin
        lowest = m[2:0];
        others = rest_q;
        others[m] = 1'b0;
      end
      if (mask_q[m]) members = members + 4'd1;
    end
  end
  logic outputs_ok;
  assign outputs_ok = active == mask_q && many == (members > 4'd1) && any_left == (rest_q != 0) &&
                      first == lowest &&
                      (word_i[31] ? entry == {1'b1, next_child_q[30:0]} : entry == word_i);

  logic [7:0] mask_n, rest_n;
  logic [31:0] child_n, next_child_n;
  always_ff @(posedge clk_i) begin
    mask_n <= low_i ? word_i[7:0] : mask_q;
    child_n <= child_i ? word_i : child_q;
    case (rest_i)
      2'd1: {rest_n, next_child_n} <= {mask_q, child_q};
      2'd2: {rest_n, next_child_n} <= {others, next_child_q + {29'd0, word_i[31], 2'd0}};
      default: {rest_n, next_child_n} <= {rest_q, next_child_q};
    endcase
  end
  assign ok_o = second_i
      ? {mask_n, rest_n, child_n, next_child_n} == {mask_q, rest_q, child_q, next_child_q}
      : outputs_ok;
endmodule
