// SPDX-License-Identifier: MIT
// Priority resolver: ordered crossings of raster lines become spans that show the active face of
// highest priority (Stump 1986, ch. II). The rules PR1 to PR8 are those of
// docs/machine/priority_resolver.md; all registers and timing are reconstruction.
`include "rtl/common/assertions.svh"

module priority_resolver #(
    parameter int Faces = 1024,  // a multiple of 32, 64 or more
    localparam int FaceWidth = $clog2(Faces)
) (
    input logic        clk_i,
    input logic        rst_i,
    input logic [13:0] cfg_width_i,  // of the raster, 1 or more

    input  logic        crossings_valid_i,
    input  logic [31:0] crossings_face_i,
    input  logic [13:0] crossings_element_i,
    input  logic        crossings_left_i,
    input  logic        crossings_end_i,
    input  logic        crossings_cut_i,
    output logic        crossings_ready_o,

    output logic                 spans_valid_o,
    output logic [FaceWidth-1:0] spans_face_o,        // where it is not the background
    output logic                 spans_background_o,
    output logic [         13:0] spans_first_o,
    output logic [         13:0] spans_end_o,
    output logic                 spans_last_o,
    input  logic                 spans_ready_i,

    // What happened at the last clock edge.
    output logic mon_entered_o,    // a face became active
    output logic mon_taken_out_o,  // a face ceased to be active
    output logic mon_too_small_o   // ever since reset: a face number of Faces or above came
);
  // What a span shows: a face, or the background.
  localparam int ShownWidth = FaceWidth + 1;
  localparam logic [ShownWidth-1:0] Background = {1'b1, {FaceWidth{1'b0}}};

  logic [13:0] at_q, at_d, start_q, start_d;
  logic [ShownWidth-1:0] shown_q, shown_d;

  // The output register.
  logic valid_q, valid_d, last_q, last_d;
  logic [13:0] first_q, first_d, end_q, end_d;
  logic [ShownWidth-1:0] face_q, face_d;

  // What the line's end leaves to be closed (PR6): [closing_first, closing_middle), where two spans
  // wait, and the line's last span, from the middle on.
  logic closing_q, closing_d, closing_two_q, closing_two_d;
  logic [13:0] closing_first_q, closing_first_d, closing_middle_q, closing_middle_d;
  logic [ShownWidth-1:0] closing_shown_q, closing_shown_d;

  // PR2, PR3.
  logic free, take, take_end, take_crossing;
  assign free = !valid_q || spans_ready_i;
  assign crossings_ready_o = free && !closing_q;
  assign take = crossings_valid_i && crossings_ready_o;
  assign take_end = take && crossings_end_i;
  assign take_crossing = take && !crossings_end_i;

  // PR1, PR5, PR8.
  logic fits, any, entered, taken_out;
  logic [FaceWidth-1:0] first_face;
  assign fits = crossings_face_i < 32'(Faces);
  active_set #(
      .Faces(Faces)
  ) active_set (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .clear_i    (take_end),
      .pass_i     (take_crossing && fits),
      .face_i     (crossings_face_i[FaceWidth-1:0]),
      .left_i     (crossings_left_i),
      .any_o      (any),
      .first_o    (first_face),
      .entered_o  (entered),
      .taken_out_o(taken_out)
  );

  // The comparison of PR4 and PR6: `limit` is where the line ends, or the crossing's element.
  logic [13:0] limit, start;
  logic [ShownWidth-1:0] answer, shown;
  logic changes, closes_changed, closes_at_cut;
  assign limit = crossings_end_i && !crossings_cut_i ? cfg_width_i : crossings_element_i;
  assign answer = any ? {1'b0, first_face} : Background;
  assign changes = at_q < limit && answer != shown_q;
  assign closes_changed = changes && start_q < at_q;
  assign start = changes ? at_q : start_q;
  assign shown = changes ? answer : shown_q;
  // The line is cut, and shows a face up to there.
  assign closes_at_cut = limit < cfg_width_i && shown != Background;

  always_comb begin
    at_d = at_q;
    start_d = start_q;
    shown_d = shown_q;
    valid_d = valid_q && !spans_ready_i;
    face_d = face_q;
    first_d = first_q;
    end_d = end_q;
    last_d = last_q;
    closing_d = closing_q;
    closing_two_d = closing_two_q;
    closing_first_d = closing_first_q;
    closing_middle_d = closing_middle_q;
    closing_shown_d = closing_shown_q;

    if (closing_q && free) begin
      valid_d = 1'b1;
      face_d = closing_shown_q;
      first_d = closing_first_q;
      end_d = closing_two_q ? closing_middle_q : cfg_width_i;
      last_d = !closing_two_q;
      closing_d = closing_two_q;
      closing_two_d = 1'b0;
      closing_first_d = closing_middle_q;
      closing_shown_d = Background;
    end else if (take_crossing) begin
      at_d = limit;
      start_d = start;
      shown_d = shown;
      if (closes_changed) begin
        valid_d = 1'b1;
        face_d = shown_q;
        first_d = start_q;
        end_d = at_q;
        last_d = 1'b0;
      end
    end else if (take_end) begin
      at_d = '0;
      start_d = '0;
      shown_d = Background;
      valid_d = 1'b1;
      if (closes_changed) begin
        face_d = shown_q;
        first_d = start_q;
        end_d = at_q;
        last_d = 1'b0;
        closing_d = 1'b1;
        closing_two_d = closes_at_cut;
        closing_first_d = start;
        closing_shown_d = shown;
      end else begin
        face_d = shown;
        first_d = start;
        end_d = closes_at_cut ? limit : cfg_width_i;
        last_d = !closes_at_cut;
        closing_d = closes_at_cut;
        closing_first_d = limit;
        closing_shown_d = Background;
      end
      closing_middle_d = limit;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      at_q <= '0;
      start_q <= '0;
      shown_q <= Background;
      valid_q <= 1'b0;
      closing_q <= 1'b0;
      closing_two_q <= 1'b0;
      mon_entered_o <= 1'b0;
      mon_taken_out_o <= 1'b0;
      mon_too_small_o <= 1'b0;
    end else begin
      at_q <= at_d;
      start_q <= start_d;
      shown_q <= shown_d;
      valid_q <= valid_d;
      closing_q <= closing_d;
      closing_two_q <= closing_two_d;
      mon_entered_o <= entered;
      mon_taken_out_o <= taken_out;
      mon_too_small_o <= mon_too_small_o || (take_crossing && !fits);
    end
  end

  always_ff @(posedge clk_i) begin
    face_q <= face_d;
    first_q <= first_d;
    end_q <= end_d;
    last_q <= last_d;
    closing_first_q <= closing_first_d;
    closing_middle_q <= closing_middle_d;
    closing_shown_q <= closing_shown_d;
  end

  assign spans_valid_o = valid_q;
  assign spans_face_o = face_q[FaceWidth-1:0];
  assign spans_background_o = face_q[FaceWidth];
  assign spans_first_o = first_q;
  assign spans_end_o = end_q;
  assign spans_last_o = last_q;

  `CIGSIM_ASSERT(CrossingsAscend, !take_crossing || crossings_element_i >= at_q)
  `CIGSIM_ASSERT(CrossingsWithinLine, !take_crossing || crossings_element_i <= cfg_width_i)
  `CIGSIM_ASSERT(LimitNotBelowCrossings, !take_end || (limit >= at_q && limit <= cfg_width_i))
  `CIGSIM_ASSERT(TwoOnlyWhereOneWaits, closing_q || !closing_two_q)
`ifdef CIGSIM_ASSERTIONS
  span_check #(
      .ShownWidth(ShownWidth)
  ) span_check (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .width_i(cfg_width_i),
      .valid_i(valid_q),
      .ready_i(spans_ready_i),
      .shown_i(face_q),
      .first_i(first_q),
      .end_i  (end_q),
      .last_i (last_q)
  );
`endif
endmodule
