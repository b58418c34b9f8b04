// SPDX-License-Identifier: MIT
// The list of active faces (Stump 1986, ch. II): a left edge enters its face, a right edge takes it
// out; the first active face is the visible one. Rules PR1, PR5 and PR8 of
// docs/machine/priority_resolver.md.
// Reconstruction: two bits a face (inside state +1, of which the encoder tells the first, and -1)
// in words of 32 faces; a bit a word that says that it was written on this line, so that the line's
// end clears all words in one cycle; a bit a word that has an active face; an encoder of two levels.
`include "rtl/common/assertions.svh"

module active_set #(
    parameter int Faces = 1024,  // a multiple of 32, 64 or more
    localparam int FaceWidth = $clog2(Faces)
) (
    input  logic                 clk_i,
    input  logic                 rst_i,
    input  logic                 clear_i,     // the line's end; never together with pass_i
    input  logic                 pass_i,      // a crossing of face_i
    input  logic [FaceWidth-1:0] face_i,      // below Faces
    input  logic                 left_i,      // of a left edge, or of a right one
    output logic                 any_o,       // a face is active
    output logic [FaceWidth-1:0] first_o,     // the first one; 0 where none is
    output logic                 entered_o,   // this crossing makes its face active
    output logic                 taken_out_o  // this crossing ends that
);
  localparam int Words = Faces / 32;
  localparam int WordWidth = $clog2(Words);

  logic [31:0] active_q[Words];
  logic [31:0] passed_q[Words];
  logic [Words-1:0] valid_q;
  logic [Words-1:0] summary_q;

  // The crossing (PR1): its face's word before, and after.
  logic [WordWidth-1:0] word;
  logic [31:0] bit_mask, active, passed, active_after, passed_after;
  assign word = face_i[FaceWidth-1:5];
  assign bit_mask = 32'd1 << face_i[4:0];
  assign active = valid_q[word] ? active_q[word] : '0;
  assign passed = valid_q[word] ? passed_q[word] : '0;
  assign active_after = left_i ? active | (bit_mask & ~passed) : active & ~bit_mask;
  assign passed_after = left_i ? passed & ~bit_mask : passed | (bit_mask & ~active);
  assign entered_o = pass_i && left_i && (active & bit_mask) == '0 && (passed & bit_mask) == '0;
  assign taken_out_o = pass_i && !left_i && (active & bit_mask) != '0;

  always_ff @(posedge clk_i) begin
    if (rst_i || clear_i) begin
      valid_q   <= '0;
      summary_q <= '0;
    end else if (pass_i) begin
      valid_q[word]   <= 1'b1;
      summary_q[word] <= active_after != '0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (pass_i) begin
      active_q[word] <= active_after;
      passed_q[word] <= passed_after;
    end
  end

  // The encoder. A word that has an active face was written on this line.
  logic [WordWidth-1:0] first_word;
  logic [31:0] shown_word;
  logic [4:0] first_bit;
  logic word_any;
  first_set #(
      .Width(Words)
  ) word_encoder (
      .bits_i (summary_q),
      .any_o  (any_o),
      .index_o(first_word)
  );
  assign shown_word = any_o ? active_q[first_word] : '0;
  first_set #(
      .Width(32)
  ) bit_encoder (
      .bits_i (shown_word),
      .any_o  (word_any),
      .index_o(first_bit)
  );
  assign first_o = {first_word, first_bit};

  `CIGSIM_ASSERT(ClearedOrPassed, !(clear_i && pass_i))
  `CIGSIM_ASSERT(FaceWithinSize, !pass_i || int'(face_i) < Faces)
  `CIGSIM_ASSERT(OneInsideState, (active_after & passed_after) == '0)
  `CIGSIM_ASSERT(SummaryOfValidWords, (summary_q & ~valid_q) == '0)
  `CIGSIM_ASSERT(SummaryOfPassedWord, !valid_q[word] || summary_q[word] == (active != '0))
  `CIGSIM_ASSERT(EncoderAgreesWithSummary, any_o == word_any)
  `CIGSIM_ASSERT(FirstWord, !any_o || (summary_q & -summary_q) == Words'(1) << first_word)
  `CIGSIM_ASSERT(FirstBit, !any_o || (shown_word & -shown_word) == 32'd1 << first_bit)
endmodule
