// SPDX-License-Identifier: MIT
// What each open group keeps while the groups below it are worked: its members by count (the order
// memory), the next place in that order, and how many places there are (the place memory). With the
// level, the innermost open group. Reconstruction (docs/machine/priority_processor.md).
`include "rtl/common/assertions.svh"

module group_places #(
    parameter int Members = 64,  // 2 to 64
    parameter int Levels = 64,   // depth of groups, 1 or more
    localparam int MemberWidth = $clog2(Members),
    localparam int ListedWidth = $clog2(Members + 1),
    localparam int LevelWidth = $clog2(Levels + 1)
) (
    input logic clk_i,
    input logic rst_i,

    input logic level_outside_i,  // out of all groups
    input logic level_inc_i,      // into a group
    input logic level_dec_i,      // out of one

    input logic                   entry_write_i,
    input logic [MemberWidth-1:0] entry_place_i,
    input logic [           31:0] entry_i,

    input logic                   place_begin_i,  // place 0 of number_i
    input logic                   place_next_i,
    input logic [ListedWidth-1:0] number_i,

    output logic [31:0] entry_o,   // at the next place
    output logic        opened_o,  // there is no next place
    output logic        inside_o   // of any group
);
  localparam int IndexWidth = Levels > 1 ? $clog2(Levels) : 1;
  localparam logic [LevelWidth-1:0] Outside = {LevelWidth{1'b1}};

  logic [LevelWidth-1:0] level_q;
  always_ff @(posedge clk_i) begin
    if (rst_i || level_outside_i) level_q <= Outside;
    else if (level_inc_i) level_q <= level_q + 1'b1;
    else if (level_dec_i) level_q <= level_q - 1'b1;
  end
  assign inside_o = level_q != Outside;
  logic [IndexWidth-1:0] index;
  assign index = level_q[IndexWidth-1:0];

  logic [2*ListedWidth-1:0] places_q[1 << IndexWidth];
  logic [ListedWidth-1:0] place, number;
  assign {number, place} = places_q[index];
  always_ff @(posedge clk_i) begin
    if (place_begin_i) places_q[index] <= {number_i, ListedWidth'(0)};
    else if (place_next_i) places_q[index] <= {number, place + 1'b1};
  end
  assign opened_o = place == number;

  logic [31:0] order_q[1 << (IndexWidth + MemberWidth)];
  always_ff @(posedge clk_i) if (entry_write_i) order_q[{index, entry_place_i}] <= entry_i;
  assign entry_o = order_q[{index, place[MemberWidth-1:0]}];

  `CIGSIM_ASSERT(level_in_range, !inside_o || level_q < LevelWidth'(Levels))
  `CIGSIM_ASSERT(level_fits, !level_inc_i || !inside_o || level_q < LevelWidth'(Levels - 1))
  `CIGSIM_ASSERT(level_moves_one_way, $onehot0({level_outside_i, level_inc_i, level_dec_i}))
  `CIGSIM_ASSERT(writes_are_inside, !(entry_write_i || place_begin_i || place_next_i) || inside_o)
  `CIGSIM_ASSERT(place_in_range, !place_next_i || place < number)
endmodule
