// SPDX-License-Identifier: MIT
// One bank of the edge memory: the edges of a picture in the order in which they came, each with
// the place of the next one that begins on its line (docs/machine/edge_orderer.md, EO5 and EO11).
// One port to write an edge or to step one, one port to read. Form and words are reconstruction.
module edge_memory #(
    parameter int Edges = 4096,  // 2 or more
    localparam int PlaceWidth = $clog2(Edges)
) (
    input logic clk_i,

    input logic                  write_i,
    input logic [PlaceWidth-1:0] write_place_i,
    input logic [          23:0] write_face_i,
    input logic                  write_left_i,
    input logic [          13:0] write_end_line_i,
    input logic [          31:0] write_x_i,
    input logic [          31:0] write_slope_i,
    input logic [PlaceWidth-1:0] write_next_i,

    input  logic [PlaceWidth-1:0] place_i,
    output logic [          23:0] face_o,
    output logic                  left_o,
    output logic [          13:0] end_line_o,
    output logic [          31:0] x_o,
    output logic [          31:0] slope_o,
    output logic [PlaceWidth-1:0] next_o,

    // The edge that is read gets a new x; never together with write_i.
    input logic        step_i,
    input logic [31:0] step_x_i
);
  logic [38:0] kind_q[Edges];
  logic [31:0] x_q[Edges];
  logic [31:0] slope_q[Edges];
  logic [PlaceWidth-1:0] next_q[Edges];

  always_ff @(posedge clk_i) begin
    if (write_i) begin
      kind_q[write_place_i] <= {write_face_i, write_left_i, write_end_line_i};
      slope_q[write_place_i] <= write_slope_i;
      next_q[write_place_i] <= write_next_i;
    end
  end

  logic [PlaceWidth-1:0] x_place;
  assign x_place = write_i ? write_place_i : place_i;
  always_ff @(posedge clk_i) begin
    if (write_i || step_i) x_q[x_place] <= write_i ? write_x_i : step_x_i;
  end

  assign {face_o, left_o, end_line_o} = kind_q[place_i];
  assign x_o = x_q[place_i];
  assign slope_o = slope_q[place_i];
  assign next_o = next_q[place_i];
endmodule
