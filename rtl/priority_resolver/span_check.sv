// SPDX-License-Identifier: MIT
// Contracts of the spans (docs/machine/priority_resolver.md, "Transactions out"; L4 of
// docs/machine.md): the spans of a line cover it exactly once, from left to right; none is empty,
// and neighbours show different things; a span that is offered stays until it is taken. No part of
// the machine.
`include "rtl/common/assertions.svh"

module span_check #(
    parameter int ShownWidth = 11
) (
    input logic                  clk_i,
    input logic                  rst_i,
    input logic [          13:0] width_i,
    input logic                  valid_i,
    input logic                  ready_i,
    input logic [ShownWidth-1:0] shown_i,
    input logic [          13:0] first_i,
    input logic [          13:0] end_i,
    input logic                  last_i
);
  localparam int SpanWidth = ShownWidth + 29;
  logic [SpanWidth-1:0] span, offered_q;
  logic waits_q;
  logic [13:0] covered_q;
  logic [ShownWidth-1:0] before_q;
  assign span = {shown_i, first_i, end_i, last_i};

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      waits_q   <= 1'b0;
      covered_q <= '0;
    end else begin
      waits_q <= valid_i && !ready_i;
      if (valid_i && ready_i) covered_q <= last_i ? '0 : end_i;
    end
    offered_q <= span;
    if (valid_i && ready_i) before_q <= shown_i;
  end

  `CIGSIM_ASSERT(SpanStaysUntilTaken, !waits_q || (valid_i && span == offered_q))
  `CIGSIM_ASSERT(SpansCoverTheLine, !valid_i || first_i == covered_q)
  `CIGSIM_ASSERT(NoSpanIsEmpty, !valid_i || first_i < end_i)
  `CIGSIM_ASSERT(LastEndsTheLine, !valid_i || (last_i ? end_i == width_i : end_i < width_i))
  `CIGSIM_ASSERT(NeighboursDiffer, !valid_i || covered_q == '0 || shown_i != before_q)
endmodule
