// SPDX-License-Identifier: MIT
// The edges that are kept from line to line (Sandor 1979, sec. 5.2), by their places in the edge
// memory. Reconstruction: a list that circulates through one memory, read at its head and written
// back at its tail. What is written while a line is in work is the list of the next line; a pass
// that is not the line's last begins again at the head. EO10 and EO11 of
// docs/machine/edge_orderer.md.
`include "rtl/common/assertions.svh"

module active_list #(
    parameter int Edges = 4096,  // 2 or more
    localparam int PlaceWidth = $clog2(Edges),
    localparam int CountWidth = $clog2(Edges + 1)
) (
    input  logic                  clk_i,
    input  logic                  rst_i,
    output logic [CountWidth-1:0] count_o,     // of the line's list, whatever was read of it
    output logic [PlaceWidth-1:0] place_o,     // the next to read
    input  logic                  read_i,
    input  logic                  write_i,
    input  logic [PlaceWidth-1:0] place_i,
    input  logic                  pass_end_i,  // after what is read and written in this cycle
    input  logic                  line_end_i   // with pass_end_i: the line is done, all was read
);
  logic [PlaceWidth-1:0] places_q[Edges];
  logic [PlaceWidth-1:0] head_q, read_q, read_d, tail_q;
  logic [CountWidth-1:0] count_q, written_q, written_d;

  function automatic logic [PlaceWidth-1:0] after(input logic [PlaceWidth-1:0] place);
    after = place == PlaceWidth'(Edges - 1) ? '0 : place + 1'b1;
  endfunction

  assign count_o = count_q;
  assign place_o = places_q[read_q];
  assign read_d = read_i ? after(read_q) : read_q;
  assign written_d = written_q + CountWidth'(write_i);

  always_ff @(posedge clk_i) begin
    if (write_i) places_q[tail_q] <= place_i;
  end
  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      head_q <= '0;
      read_q <= '0;
      tail_q <= '0;
      count_q <= '0;
      written_q <= '0;
    end else begin
      read_q <= pass_end_i && !line_end_i ? head_q : read_d;
      if (write_i) tail_q <= after(tail_q);
      written_q <= line_end_i ? '0 : written_d;
      if (line_end_i) begin
        head_q <= read_d;
        count_q <= written_d;
      end
    end
  end

`ifdef CIGSIM_ASSERTIONS
  logic [CountWidth-1:0] unread_q;
  always_ff @(posedge clk_i) begin
    if (rst_i) unread_q <= '0;
    else if (line_end_i) unread_q <= written_d;
    else if (pass_end_i) unread_q <= count_q;
    else unread_q <= unread_q - CountWidth'(read_i);
  end
  `CIGSIM_ASSERT(OnlyWhatIsListedIsRead, !read_i || unread_q != '0)
  `CIGSIM_ASSERT(PassReadsTheWholeList, !pass_end_i || unread_q == CountWidth'(read_i))
  `CIGSIM_ASSERT(UnreadStays,
                 !write_i || 32'(unread_q) + 32'(written_q) < Edges || read_i)
`endif
endmodule
