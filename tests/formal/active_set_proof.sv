// SPDX-License-Identifier: MIT
// One step of active_set with 64 faces, by rules PR1, PR5 and PR8 of docs/machine/
// priority_resolver.md: the inside states of all faces, -1, 0 or +1, and the first face at +1. From
// any registers that are the states of a line: no face has two, and a word's summary is of it.
// registers: active_q[2x32] passed_q[2x32] valid_q summary_q
module active_set_proof #(
    parameter int Faces = 64
) (
    input logic       clk_i,
    input logic       second_i,
    input logic       rst_i,
    input logic [1:0] what_i,  // 1: the line's end; 2: a crossing
    input logic [5:0] face_i,
    input logic       left_i,

    input logic [63:0] active_q,
    input logic [63:0] passed_q,
    input logic [ 1:0] valid_q,
    input logic [ 1:0] summary_q,
    output logic       ok_o
);
  logic any, entered, taken_out;
  logic [5:0] first;
  active_set #(.Faces(Faces)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .clear_i(what_i == 2'd1), .pass_i(what_i == 2'd2),
      .face_i(face_i), .left_i(left_i), .any_o(any), .first_o(first), .entered_o(entered),
      .taken_out_o(taken_out)
  );

  // The faces at +1 and at -1; words that were not written on the line have none.
  logic [63:0] plus, minus;
  logic summary_ok, states_ok;
  assign plus = active_q & {{32{valid_q[1]}}, {32{valid_q[0]}}};
  assign minus = passed_q & {{32{valid_q[1]}}, {32{valid_q[0]}}};
  assign summary_ok = summary_q == {plus[63:32] != 0, plus[31:0] != 0};
  assign states_ok = (plus & minus) == 0 && summary_ok;

  logic at_plus, at_minus, outputs_ok;
  logic [5:0] lowest;
  always_comb begin
    lowest = 6'd0;
    for (int f = 63; f >= 0; f--) if (plus[f]) lowest = f[5:0];
    at_plus = 1'b0;
    at_minus = 1'b0;
    for (int f = 0; f < 64; f++)
      if (face_i == f) begin
        at_plus = plus[f];
        at_minus = minus[f];
      end
    outputs_ok = any == (plus != 0) && first == lowest &&
        entered == (what_i == 2'd2 && left_i && !at_plus && !at_minus) &&
        taken_out == (what_i == 2'd2 && !left_i && at_plus);
  end

  logic [63:0] plus_n, minus_n;
  logic states_ok_q;
  always_ff @(posedge clk_i) begin
    states_ok_q <= states_ok;
    plus_n <= plus;
    minus_n <= minus;
    for (int f = 0; f < 64; f++)
      if (what_i == 2'd2 && face_i == f) begin
        // One more, or one less, within -1 .. +1.
        plus_n[f] <= left_i && !minus[f];
        minus_n[f] <= !left_i && !plus[f];
      end
    if (rst_i || what_i == 2'd1) {plus_n, minus_n} <= '0;
  end
  assign ok_o = second_i ? !states_ok_q || (states_ok && plus == plus_n && minus == minus_n)
                         : !states_ok || outputs_ok;
endmodule
