// SPDX-License-Identifier: MIT
// One step of line_overload from any values in its registers, by rule EO4 of docs/machine/
// edge_orderer.md, policy by policy. What the rule does not tell is as simple as it can be: `rest`
// is kept under every policy, and told only with a cut.
// registers: limited_q cut_q marked_q pass_ended_q limit_q rest_q mark_q
module line_overload_proof #(
    parameter int Crossings = 16,
    parameter int PlaceWidth = 7,
    localparam int KeyWidth = 39 + PlaceWidth,
    localparam int CountWidth = $clog2(Crossings + 1)
) (
    input logic                  clk_i,
    input logic                  second_i,
    input logic                  rst_i,
    input logic [           1:0] policy_i,
    input logic [          31:0] capacity_i,
    input logic                  crossing_i,
    input logic [          13:0] element_i,
    input logic                  left_i,
    input logic [          23:0] face_i,
    input logic [PlaceWidth-1:0] place_i,
    input logic                  pass_end_i,
    input logic                  line_end_i,
    input logic [CountWidth-1:0] count_i,
    input logic [  KeyWidth-1:0] last_i,
    input logic [          23:0] highest_i,
    input logic [CountWidth-1:0] cleared_i,
    input logic [  KeyWidth-1:0] pass_last_i,

    input logic                limited_q,
    input logic                cut_q,
    input logic                marked_q,
    input logic                pass_ended_q,
    input logic [        23:0] limit_q,
    input logic [        13:0] rest_q,
    input logic [KeyWidth-1:0] mark_q,
    output logic               ok_o
);
  logic search, insert, replace, clear, overfull, cut, too_small;
  logic [23:0] limit;
  logic [13:0] rest;
  logic [CountWidth:0] dropped;
  line_overload #(.Crossings(Crossings), .PlaceWidth(PlaceWidth)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .policy_i(policy_i), .capacity_i(capacity_i),
      .crossing_i(crossing_i), .key_i({element_i, left_i, face_i, place_i}),
      .pass_end_i(pass_end_i), .line_end_i(line_end_i), .count_i(count_i), .last_i(last_i),
      .highest_i(highest_i), .cleared_i(cleared_i), .search_o(search), .insert_o(insert),
      .replace_o(replace), .clear_o(clear), .limit_o(limit), .pass_last_i(pass_last_i),
      .overfull_o(overfull), .cut_o(cut), .rest_o(rest), .dropped_o(dropped),
      .too_small_o(too_small)
  );

  // The crossing is looked at: faces from the limit on, and what passes before had, are not.
  logic drops, cuts, looked_at, all_full, no_cell;
  always_comb begin
    cuts = policy_i == 2'd1;
    drops = policy_i == 2'd0 || policy_i == 2'd3;
    looked_at = crossing_i;
    if (drops && limited_q && face_i >= limit_q) looked_at = 1'b0;
    if (!drops && marked_q && {element_i, left_i, face_i, place_i} <= mark_q) looked_at = 1'b0;
    all_full = looked_at && capacity_i != 0 && capacity_i == {{(32 - CountWidth) {1'b0}}, count_i};
    no_cell = looked_at && !all_full && count_i == Crossings;
  end

  // What then happens, and the registers after it.
  logic insert_d, replace_d, limited_d, cut_d, marked_d, later;
  logic [23:0] limit_d;
  logic [13:0] rest_d, out;
  logic [CountWidth:0] dropped_d;
  always_comb begin
    insert_d = looked_at && !no_cell;
    replace_d = 1'b0;
    limited_d = limited_q;
    cut_d = cut_q;
    limit_d = limit_q;
    rest_d = rest_q;
    dropped_d = '0;
    later = {element_i, left_i, face_i, place_i} >= last_i;
    out = later ? element_i : last_i[KeyWidth-1-:14];
    if (all_full) begin
      if (drops) begin
        limited_d = 1'b1;
        limit_d = face_i < highest_i ? highest_i : face_i;
        insert_d = face_i < highest_i;
        dropped_d = {1'b0, cleared_i};
      end else begin
        insert_d = !later;
        replace_d = !later;
        if (cuts) begin
          cut_d = 1'b1;
          dropped_d = 1;
        end
      end
      if (!cut_q || out < rest_q) rest_d = out;
    end
    if (drops && crossing_i && !insert_d && !no_cell) dropped_d = dropped_d + 1'b1;
  end

  logic outputs_ok;
  assign outputs_ok = search == (all_full && drops) && clear == (all_full && drops) &&
      insert == insert_d && replace == replace_d && limit == limit_d && too_small == no_cell &&
      overfull == (limited_d || cut_d || marked_q) && cut == cut_d && rest == rest_d &&
      dropped == dropped_d;

  logic [KeyWidth+41:0] after;
  always_ff @(posedge clk_i) begin
    after <= {rst_i || line_end_i ? 4'd0 : {limited_d, cut_d, marked_q || pass_end_i, pass_end_i},
              limit_d, rest_d, pass_ended_q ? pass_last_i : mark_q};
  end
  assign ok_o = second_i
      ? after == {limited_q, cut_q, marked_q, pass_ended_q, limit_q, rest_q, mark_q} : outputs_ok;
endmodule
