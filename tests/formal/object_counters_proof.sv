// SPDX-License-Identifier: MIT
// One step of object_counters with 8 members from any values in its registers, by rules PP2 and PP3
// of docs/machine/priority_processor.md.
// registers: counts_q[8x6] seen_q twice_q largest_q listed_q
module object_counters_proof #(
    parameter int Members = 8
) (
    input logic       clk_i,
    input logic       second_i,
    input logic [1:0] count_i,        // 1: all counters to zero; 2: a pair
    input logic [5:0] true_member_i,
    input logic [5:0] false_member_i,
    input logic       eye_true_i,
    input logic [7:0] active_i,
    input logic [1:0] list_i,         // 1: nothing listed; 2: listed at its count; 3: by rank
    input logic [2:0] member_i,
    input logic [5:0] rank_i,

    input logic [47:0] counts_q,
    input logic [ 7:0] seen_q,
    input logic        twice_q,
    input logic [ 5:0] largest_q,
    input logic [ 3:0] listed_q,
    output logic       ok_o
);
  logic list, fault;
  logic [2:0] place;
  logic [3:0] listed;
  object_counters #(.Members(Members)) dut (
      .clk_i(clk_i), .rst_i(1'b0), .clear_i(count_i == 2'd1), .pair_i(count_i == 2'd2),
      .true_member_i(true_member_i), .false_member_i(false_member_i), .eye_true_i(eye_true_i),
      .active_i(active_i), .list_clear_i(list_i == 2'd1), .list_count_i(list_i == 2'd2),
      .list_rank_i(list_i == 2'd3), .member_i(member_i), .rank_i(rank_i), .list_o(list),
      .place_o(place), .listed_o(listed), .fault_o(fault)
  );

  // Member by member: both of the pair are there; the one opposite the eye counts, up to 63.
  logic true_there, false_there;
  logic [5:0] opposite, count;
  logic [47:0] counts_d;
  always_comb begin
    true_there = 1'b0;
    false_there = 1'b0;
    opposite = eye_true_i ? false_member_i : true_member_i;
    count = 6'd0;
    for (int m = 0; m < 8; m++) begin
      if (active_i[m] && true_member_i == m) true_there = 1'b1;
      if (active_i[m] && false_member_i == m) false_there = 1'b1;
      if (member_i == m) count = counts_q[m*6+:6];
    end
    counts_d = counts_q;
    for (int m = 0; m < 8; m++)
      if (count_i == 2'd1) counts_d[m*6+:6] = 6'd0;
      else if (count_i == 2'd2 && true_there && false_there && opposite == m &&
               counts_q[m*6+:6] < 6'd63)
        counts_d[m*6+:6] = counts_q[m*6+:6] + 6'd1;
  end

  // The listing, and the check of it. Without a member at its count the place is the next one.
  logic lists, outputs_ok;
  logic [7:0] seen_d;
  logic twice_d;
  logic [5:0] largest_d;
  logic [3:0] listed_d;
  always_comb begin
    lists = list_i == 2'd2 || (list_i == 2'd3 && count == rank_i);
    outputs_ok = list == lists && listed == listed_q &&
        place == (list_i == 2'd2 ? count[2:0] : listed_q[2:0]) &&
        fault == (twice_q || (listed_q > 0 && {26'd0, largest_q} + 32'd1 > {28'd0, listed_q}));
    {seen_d, twice_d, largest_d, listed_d} = {seen_q, twice_q, largest_q, listed_q};
    if (list_i == 2'd1) {seen_d, twice_d, largest_d, listed_d} = 19'd0;
    if (list_i == 2'd2) begin
      for (int n = 0; n < 8; n++)
        if (count == n) begin
          if (seen_q[n]) twice_d = 1'b1;
          seen_d[n] = 1'b1;
        end
      if (count > largest_q) largest_d = count;
    end
    if (lists) listed_d = listed_q + 4'd1;
  end

  logic [66:0] after;
  always_ff @(posedge clk_i) after <= {counts_d, seen_d, twice_d, largest_d, listed_d};
  assign ok_o = second_i ? after == {counts_q, seen_q, twice_q, largest_q, listed_q} : outputs_ok;
endmodule
