// SPDX-License-Identifier: MIT
// One step of bucket_memory from any values in its registers, by rules EO5 and EO9 of docs/machine/
// edge_orderer.md: of each line what came last, and how many came.
// registers: first_q[LinesxPlaceWidth] count_q[LinesxPlaceWidth] begun_q
module bucket_memory_proof #(
    parameter int Edges = 100,
    parameter int Lines = 16,      // a power of two
    parameter int PlaceWidth = 7,  // of numbers up to Edges
    localparam int LineWidth = $clog2(Lines)
) (
    input logic                  clk_i,
    input logic                  second_i,
    input logic                  rst_i,
    input logic                  add_i,
    input logic [ LineWidth-1:0] add_line_i,
    input logic [PlaceWidth-1:0] add_place_i,
    input logic [ LineWidth-1:0] line_i,
    input logic                  empty_i,

    input logic [Lines*PlaceWidth-1:0] first_q,
    input logic [Lines*PlaceWidth-1:0] count_q,
    input logic [           Lines-1:0] begun_q,
    output logic                       ok_o
);
  logic [PlaceWidth-1:0] behind, first, count;
  bucket_memory #(.Edges(Edges), .Lines(Lines)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .add_i(add_i), .add_line_i(add_line_i),
      .add_place_i(add_place_i), .behind_o(behind), .line_i(line_i), .first_o(first),
      .count_o(count), .empty_i(empty_i && !add_i)
  );

  // Bucket by bucket: how many edges it has.
  logic outputs_ok;
  logic [Lines*PlaceWidth-1:0] first_n, count_n;
  logic [Lines-1:0] begun_n;
  always_comb begin
    outputs_ok = 1'b1;
    for (int n = 0; n < Lines; n++) begin
      if (add_line_i == n && behind != first_q[n*PlaceWidth+:PlaceWidth]) outputs_ok = 1'b0;
      if (line_i == n && (first != first_q[n*PlaceWidth+:PlaceWidth] ||
                          count != (begun_q[n] ? count_q[n*PlaceWidth+:PlaceWidth] : 0)))
        outputs_ok = 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    {first_n, count_n, begun_n} <= {first_q, count_q, begun_q};
    for (int n = 0; n < Lines; n++)
      if (add_i && add_line_i == n) begin
        first_n[n*PlaceWidth+:PlaceWidth] <= add_place_i;
        count_n[n*PlaceWidth+:PlaceWidth] <=
            (begun_q[n] ? count_q[n*PlaceWidth+:PlaceWidth] : 0) + 1;
        begun_n[n] <= 1'b1;
      end else if (!add_i && empty_i && line_i == n) begin
        begun_n[n] <= 1'b0;
      end
    if (rst_i) begun_n <= '0;
  end
  assign ok_o = second_i ? {first_n, count_n, begun_n} == {first_q, count_q, begun_q} : outputs_ok;
endmodule
