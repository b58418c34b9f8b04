// SPDX-License-Identifier: MIT
// One step of edge_memory from any values in its registers, by rules EO5 and EO11 of docs/machine/
// edge_orderer.md: an edge is where it was written, with the x that it was stepped to.
// registers: kind_q[Edgesx39] x_q[Edgesx32] slope_q[Edgesx32] next_q[EdgesxPlaceWidth]
module edge_memory_proof #(
    parameter int Edges = 100,
    parameter int PlaceWidth = 7  // of numbers below Edges
) (
    input logic                  clk_i,
    input logic                  second_i,
    input logic                  write_i,
    input logic [PlaceWidth-1:0] write_place_i,
    input logic [          23:0] face_i,
    input logic                  left_i,
    input logic [          13:0] end_line_i,
    input logic [          31:0] x_i,
    input logic [          31:0] slope_i,
    input logic [PlaceWidth-1:0] next_i,
    input logic [PlaceWidth-1:0] place_i,
    input logic                  step_i,
    input logic [          31:0] step_x_i,

    input logic [        Edges*39-1:0] kind_q,  // face, left, end line
    input logic [        Edges*32-1:0] x_q,
    input logic [        Edges*32-1:0] slope_q,
    input logic [Edges*PlaceWidth-1:0] next_q,
    output logic                       ok_o
);
  logic [23:0] face;
  logic left;
  logic [13:0] end_line;
  logic [31:0] x, slope;
  logic [PlaceWidth-1:0] next;
  edge_memory #(.Edges(Edges)) dut (
      .clk_i(clk_i), .write_i(write_i), .write_place_i(write_place_i), .write_face_i(face_i),
      .write_left_i(left_i), .write_end_line_i(end_line_i), .write_x_i(x_i),
      .write_slope_i(slope_i), .write_next_i(next_i), .place_i(place_i), .face_o(face),
      .left_o(left), .end_line_o(end_line), .x_o(x), .slope_o(slope), .next_o(next),
      .step_i(step_i && !write_i), .step_x_i(step_x_i)
  );

  logic outputs_ok;
  logic [Edges*39-1:0] kind_n;
  logic [Edges*32-1:0] x_n, slope_n;
  logic [Edges*PlaceWidth-1:0] next_n;
  always_comb begin
    outputs_ok = 1'b1;
    for (int n = 0; n < Edges; n++)
      if (place_i == n && {face, left, end_line, x, slope, next} !=
          {kind_q[n*39+:39], x_q[n*32+:32], slope_q[n*32+:32], next_q[n*PlaceWidth+:PlaceWidth]})
        outputs_ok = 1'b0;
  end
  always_ff @(posedge clk_i) begin
    {kind_n, x_n, slope_n, next_n} <= {kind_q, x_q, slope_q, next_q};
    for (int n = 0; n < Edges; n++) begin
      if (step_i && !write_i && place_i == n) x_n[n*32+:32] <= step_x_i;
      if (write_i && write_place_i == n) begin
        kind_n[n*39+:39] <= {face_i, left_i, end_line_i};
        x_n[n*32+:32] <= x_i;
        slope_n[n*32+:32] <= slope_i;
        next_n[n*PlaceWidth+:PlaceWidth] <= next_i;
      end
    end
  end
  assign ok_o = second_i ? {kind_n, x_n, slope_n, next_n} == {kind_q, x_q, slope_q, next_q}
                         : outputs_ok;
endmodule
