// SPDX-License-Identifier: MIT
// A counter a member, in the source an object (Stump 1986, ch. II and III): for each pair of a
// separation plane the member on the side opposite the eye counts one more, and the counts are then
// the order. With the check that they are unique: counts met, one met twice, the largest, and how
// many members were listed. A saturation at 63, and the form of the check, are reconstruction
// (docs/machine/priority_processor.md, rules PP2 and PP3).
`include "rtl/common/assertions.svh"

module object_counters #(
    parameter int Members = 64,  // 2 to 64; those beyond are never active
    localparam int MemberWidth = $clog2(Members),
    localparam int ListedWidth = $clog2(Members + 1)
) (
    input logic clk_i,
    input logic rst_i,

    input logic               clear_i,         // all counters
    input logic               pair_i,          // a pair: TRUE and FALSE member
    input logic [        5:0] true_member_i,
    input logic [        5:0] false_member_i,
    input logic               eye_true_i,
    input logic [Members-1:0] active_i,

    input logic                   list_clear_i,  // nothing listed yet
    input logic                   list_count_i,  // the member is listed at its count
    input logic                   list_rank_i,   // the member is listed next, if its count is rank
    input logic [MemberWidth-1:0] member_i,
    input logic [            5:0] rank_i,

    output logic                   list_o,    // the member is listed now
    output logic [MemberWidth-1:0] place_o,   // in the order, if it is
    output logic [ListedWidth-1:0] listed_o,  // how many are listed
    output logic                   fault_o
);
  localparam logic [5:0] MostCount = 6'd63;

  function automatic logic is_member(logic [5:0] number);
    is_member = 7'(number) < 7'(Members);
  endfunction

  logic [MemberWidth-1:0] true_member, false_member, counted;
  logic count_one;
  assign true_member = true_member_i[MemberWidth-1:0];
  assign false_member = false_member_i[MemberWidth-1:0];
  assign counted = eye_true_i ? false_member : true_member;
  assign count_one = pair_i && is_member(true_member_i) && is_member(false_member_i) &&
                     active_i[true_member] && active_i[false_member];

  logic [5:0] counts_q[Members];
  always_ff @(posedge clk_i) begin
    if (clear_i) begin
      for (int m = 0; m < Members; m++) counts_q[m] <= '0;
    end else if (count_one && counts_q[counted] != MostCount) begin
      counts_q[counted] <= counts_q[counted] + 6'd1;
    end
  end

  logic [5:0] count;
  assign count = counts_q[member_i];

  // Counts from Members on need no bit of seen: they are a fault by being too large.
  logic [Members-1:0] seen_q;
  logic twice_q;
  logic [5:0] largest_q;
  logic [ListedWidth-1:0] listed_q;
  assign list_o = list_count_i || (list_rank_i && count == rank_i);
  assign place_o = list_count_i ? count[MemberWidth-1:0] : listed_q[MemberWidth-1:0];
  always_ff @(posedge clk_i) begin
    if (list_clear_i) begin
      seen_q <= '0;
      twice_q <= 1'b0;
      largest_q <= '0;
      listed_q <= '0;
    end else begin
      if (list_count_i && is_member(count)) begin
        seen_q[count[MemberWidth-1:0]] <= 1'b1;
        twice_q <= twice_q || seen_q[count[MemberWidth-1:0]];
      end
      if (list_count_i && count > largest_q) largest_q <= count;
      if (list_o) listed_q <= listed_q + 1'b1;
    end
  end

  assign listed_o = listed_q;
  assign fault_o = twice_q || (listed_q != '0 && 7'(largest_q) >= 7'(listed_q));

  `CIGSIM_ASSERT(pair_of_members, !pair_i || (is_member(true_member_i) &&
                 is_member(false_member_i) && true_member_i != false_member_i))
  `CIGSIM_ASSERT(listed_in_range, !list_o || listed_q < ListedWidth'(Members))
  `CIGSIM_ASSERT(listed_is_active, !(list_count_i || list_rank_i) || active_i[member_i])
  `CIGSIM_ASSERT(one_step_a_clock, $onehot0({clear_i, pair_i}) &&
                 $onehot0({list_clear_i, list_count_i, list_rank_i}))
endmodule
