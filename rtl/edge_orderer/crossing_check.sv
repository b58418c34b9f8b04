// SPDX-License-Identifier: MIT
// Contracts of the crossings (docs/machine/edge_orderer.md, EO3, EO4 and "Transactions out"; L4 of
// docs/machine.md): those of a line come in their order; a line is never cut before a crossing that
// it has; end words hold what they may; a word that is offered stays until it is taken. No part of
// the machine.
`include "rtl/common/assertions.svh"

module crossing_check (
    input logic        clk_i,
    input logic        rst_i,
    input logic [13:0] width_i,
    input logic        valid_i,
    input logic        ready_i,
    input logic [23:0] face_i,
    input logic [13:0] element_i,
    input logic        left_i,
    input logic        end_i,
    input logic        cut_i
);
  logic [40:0] word, offered_q;
  logic [38:0] order, before_q;
  logic waits_q, begun_q;
  assign word = {element_i, left_i, face_i, end_i, cut_i};
  assign order = {element_i, left_i, face_i};

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      waits_q <= 1'b0;
      begun_q <= 1'b0;
    end else begin
      waits_q <= valid_i && !ready_i;
      if (valid_i && ready_i) begun_q <= !end_i;
    end
    offered_q <= word;
    if (valid_i && ready_i) before_q <= order;
  end

  `CIGSIM_ASSERT(CrossingStaysUntilTaken, !waits_q || (valid_i && word == offered_q))
  `CIGSIM_ASSERT(CrossingsInOrder, !(valid_i && begun_q && !end_i) || before_q <= order)
  `CIGSIM_ASSERT(CutBehindTheCrossings,
                 !(valid_i && begun_q && cut_i) || before_q[38-:14] <= element_i)
  `CIGSIM_ASSERT(EndWordsAreEmpty,
                 !(valid_i && end_i) || (face_i == '0 && !left_i && (cut_i || element_i == '0)))
  `CIGSIM_ASSERT(OnlyEndWordsCut, !valid_i || end_i || !cut_i)
  `CIGSIM_ASSERT(ElementInTheRaster, !valid_i || element_i <= width_i)
endmodule
