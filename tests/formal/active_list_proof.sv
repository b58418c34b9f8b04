// SPDX-License-Identifier: MIT
// One step of active_list from any values in its registers, by rules EO10 and EO11 of docs/machine/
// edge_orderer.md: a memory that is read at its head and written at its tail, round and round.
// registers: places_q[EdgesxPlaceWidth] head_q read_q tail_q count_q written_q
module active_list_proof #(
    parameter int Edges = 100,
    parameter int PlaceWidth = 7,  // of numbers below Edges
    localparam int CountWidth = $clog2(Edges + 1)
) (
    input logic                  clk_i,
    input logic                  second_i,
    input logic                  rst_i,
    input logic                  read_i,
    input logic                  write_i,
    input logic [PlaceWidth-1:0] place_i,
    input logic                  pass_end_i,
    input logic                  line_end_i,

    input logic [Edges*PlaceWidth-1:0] places_q,
    input logic [      PlaceWidth-1:0] head_q,
    input logic [      PlaceWidth-1:0] read_q,
    input logic [      PlaceWidth-1:0] tail_q,
    input logic [      CountWidth-1:0] count_q,
    input logic [      CountWidth-1:0] written_q,
    output logic                       ok_o
);
  logic [CountWidth-1:0] count;
  logic [PlaceWidth-1:0] place;
  active_list #(.Edges(Edges)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .count_o(count), .place_o(place), .read_i(read_i),
      .write_i(write_i), .place_i(place_i), .pass_end_i(pass_end_i || line_end_i),
      .line_end_i(line_end_i)
  );

  // The memory is a ring of Edges words.
  function automatic logic [PlaceWidth-1:0] next(input logic [PlaceWidth-1:0] at, input logic on);
    next = !on ? at : at + 1 < Edges ? at + 1'b1 : '0;
  endfunction

  logic [PlaceWidth-1:0] at_read, head_n, read_n, tail_n;
  logic [CountWidth-1:0] count_n, written_n;
  logic [Edges*PlaceWidth-1:0] places_n;
  logic in_ring, in_ring_q;
  always_comb begin
    at_read = '0;
    for (int n = 0; n < Edges; n++) if (read_q == n) at_read = places_q[n*PlaceWidth+:PlaceWidth];
    in_ring = head_q < Edges && read_q < Edges && tail_q < Edges;
  end
  always_ff @(posedge clk_i) begin
    in_ring_q <= in_ring;
    for (int n = 0; n < Edges; n++)
      places_n[n*PlaceWidth+:PlaceWidth] <=
          write_i && tail_q == n ? place_i : places_q[n*PlaceWidth+:PlaceWidth];
    head_n <= head_q;
    tail_n <= next(tail_q, write_i);
    count_n <= count_q;
    written_n <= written_q + {{(CountWidth - 1) {1'b0}}, write_i};
    read_n <= next(read_q, read_i);
    // Another pass of the line, or the next line.
    if (pass_end_i && !line_end_i) read_n <= head_q;
    if (line_end_i) begin
      head_n <= next(read_q, read_i);
      count_n <= written_q + {{(CountWidth - 1) {1'b0}}, write_i};
      written_n <= '0;
    end
    if (rst_i) {head_n, read_n, tail_n, count_n, written_n} <= '0;
  end
  assign ok_o = second_i
      ? !in_ring_q || {places_n, head_n, read_n, tail_n, count_n, written_n} ==
                      {places_q, head_q, read_q, tail_q, count_q, written_q}
      : !in_ring || (count == count_q && place == at_read);
endmodule
