// SPDX-License-Identifier: MIT
// What becomes of a line with more crossings than the sorting memory may hold: rule EO4 of
// docs/machine/edge_orderer.md, and its registers limit, rest and mark; of rest only the element,
// as no more is told. For a crossing that comes it tells the sorting memory what to do.
// Reconstruction: no published behaviour of GE's machines under overload was found.
`include "rtl/common/assertions.svh"

module line_overload #(
    parameter int Crossings = 256,
    parameter int PlaceWidth = 12,
    localparam int KeyWidth = 14 + 1 + 24 + PlaceWidth,
    localparam int CountWidth = $clog2(Crossings + 1)
) (
    input logic        clk_i,
    input logic        rst_i,
    input logic [ 1:0] policy_i,    // 0 drop, 1 cut, 2 extend
    input logic [31:0] capacity_i,  // 0: no limit

    input logic                crossing_i,  // one comes
    input logic [KeyWidth-1:0] key_i,
    input logic                pass_end_i,  // with it, or without
    input logic                line_end_i,  // with pass_end_i: the pass is the line's last

    // The sorting memory that is filled (sorting_memory.sv).
    input  logic [CountWidth-1:0] count_i,
    input  logic [  KeyWidth-1:0] last_i,
    input  logic [          23:0] highest_i,
    input  logic [CountWidth-1:0] cleared_i,
    output logic                  search_o,
    output logic                  insert_o,
    output logic                  replace_o,
    output logic                  clear_o,
    output logic [          23:0] limit_o,

    // The last crossing of the pass that ended in the cycle before.
    input logic [KeyWidth-1:0] pass_last_i,

    // With what this cycle's crossing does.
    output logic                overfull_o,
    output logic                cut_o,
    output logic [        13:0] rest_o,      // element of the first crossing that was not kept
    output logic [CountWidth:0] dropped_o,   // crossings, by this cycle
    output logic                too_small_o  // no limit, and no cell for this cycle's crossing
);
  localparam logic [1:0] Cut = 2'd1, Extend = 2'd2;

  logic limited_q, limited_d, cut_q, cut_d, marked_q, pass_ended_q;
  logic [23:0] limit_q, limit_d;
  logic [13:0] rest_q, rest_d;
  logic [KeyWidth-1:0] mark_q;

  logic [23:0] face;
  assign face = key_i[PlaceWidth+:24];

  logic bounded, at_capacity, no_cell;
  assign bounded = capacity_i != '0;
  assign at_capacity = bounded && 32'(count_i) == capacity_i;
  assign no_cell = count_i == CountWidth'(Crossings);

  // Of the crossing and the last cell the later one, which is pushed out of a full memory.
  logic before_last;
  logic [13:0] pushed_out;
  assign before_last = key_i < last_i;
  assign pushed_out = before_last ? last_i[KeyWidth-1-:14] : key_i[KeyWidth-1-:14];

  logic by_faces, wanted, full;
  assign by_faces = policy_i != Cut && policy_i != Extend;
  assign wanted = by_faces ? !limited_q || face < limit_q : !marked_q || mark_q < key_i;
  assign full = crossing_i && wanted && at_capacity;
  assign too_small_o = crossing_i && wanted && !at_capacity && no_cell;

  assign search_o = full && by_faces;
  assign clear_o = search_o;
  assign limit_d = !search_o ? limit_q : highest_i > face ? highest_i : face;
  assign limited_d = limited_q || search_o;
  assign limit_o = limit_d;

  assign replace_o = full && !by_faces && before_last;
  assign insert_o = crossing_i && wanted && !too_small_o &&
      (!full || (by_faces ? face < limit_d : before_last));

  assign cut_d = cut_q || (full && policy_i == Cut);
  assign rest_d = full && (!cut_q || pushed_out < rest_q) ? pushed_out : rest_q;

  assign overfull_o = limited_d || cut_d || marked_q;
  assign cut_o = cut_d;
  assign rest_o = rest_d;

  logic this_dropped;
  assign this_dropped = by_faces ? crossing_i && !too_small_o && !insert_o :
      full && policy_i == Cut;
  assign dropped_o = (clear_o ? {1'b0, cleared_i} : '0) + {{CountWidth{1'b0}}, this_dropped};

  always_ff @(posedge clk_i) begin
    if (rst_i || line_end_i) begin
      limited_q <= 1'b0;
      cut_q <= 1'b0;
      marked_q <= 1'b0;
      pass_ended_q <= 1'b0;
    end else begin
      limited_q <= limited_d;
      cut_q <= cut_d;
      marked_q <= marked_q || pass_end_i;
      pass_ended_q <= pass_end_i;
    end
    limit_q <= limit_d;
    rest_q <= rest_d;
    if (pass_ended_q) mark_q <= pass_last_i;
  end

  `CIGSIM_ASSERT(LimitOnlyFalls, !(limited_q && search_o) || limit_d < limit_q)
  `CIGSIM_ASSERT(MarkIsThereInTime, !(crossing_i && pass_ended_q))
  `CIGSIM_ASSERT(MoreThanTheCapacityNeverFits, !bounded || 32'(count_i) <= capacity_i)
  `CIGSIM_ASSERT(OneOfTheRegistersAtMost, 32'(limited_q) + 32'(cut_q) + 32'(marked_q) <= 1)
endmodule
