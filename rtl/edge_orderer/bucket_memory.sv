// SPDX-License-Identifier: MIT
// One bank of the bucket memory, the sort of the edges by their first line (Sandor 1979, sec. 5.2):
// for each raster line the edge that came last of those that begin there, and how many do. The
// others are found through the edge memory. A bit a line tells that its bucket is not empty, so
// that the memory begins empty, and is emptied line by line as it is read. EO5 and EO9 of
// docs/machine/edge_orderer.md; form is reconstruction.
module bucket_memory #(
    parameter int Edges = 4096,  // 2 or more
    parameter int Lines = 1024,  // 2 or more
    localparam int PlaceWidth = $clog2(Edges),
    localparam int CountWidth = $clog2(Edges + 1),
    localparam int LineWidth = $clog2(Lines)
) (
    input logic clk_i,
    input logic rst_i,

    // An edge is put in front of the bucket of a line.
    input  logic                  add_i,
    input  logic [ LineWidth-1:0] add_line_i,
    input  logic [PlaceWidth-1:0] add_place_i,
    output logic [PlaceWidth-1:0] behind_o,  // what was in front; anything where it was empty

    input  logic [ LineWidth-1:0] line_i,
    output logic [PlaceWidth-1:0] first_o,  // anything where the count is 0
    output logic [CountWidth-1:0] count_o,
    input  logic                  empty_i   // line_i's bucket; never together with add_i
);
  logic [PlaceWidth-1:0] first_q[Lines];
  logic [CountWidth-1:0] count_q[Lines];
  logic [Lines-1:0] begun_q;

  logic [CountWidth-1:0] add_count;
  assign behind_o = first_q[add_line_i];
  assign add_count = begun_q[add_line_i] ? count_q[add_line_i] + 1'b1 : CountWidth'(1);

  always_ff @(posedge clk_i) begin
    if (add_i) begin
      first_q[add_line_i] <= add_place_i;
      count_q[add_line_i] <= add_count;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      begun_q <= '0;
    end else if (add_i) begin
      begun_q[add_line_i] <= 1'b1;
    end else if (empty_i) begin
      begun_q[line_i] <= 1'b0;
    end
  end

  assign first_o = first_q[line_i];
  assign count_o = begun_q[line_i] ? count_q[line_i] : '0;
endmodule
