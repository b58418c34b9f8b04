// SPDX-License-Identifier: MIT
// One step of priority_resolver from any values in its registers, by rules PR2 to PR8 of
// docs/machine/priority_resolver.md. What its active set answers is any answer (active_set_proof.sv
// is of the active set itself).
// registers: at_q start_q shown_q valid_q face_q first_q end_q last_q closing_q closing_two_q closing_first_q closing_middle_q closing_shown_q any=active_set.any_o first_face=active_set.first_o entered=active_set.entered_o taken_out=active_set.taken_out_o set_clear=active_set.clear_i set_pass=active_set.pass_i set_face=active_set.face_i set_left=active_set.left_i
module priority_resolver_proof #(
    parameter int Faces = 64
) (
    input logic        clk_i,
    input logic        second_i,
    input logic        rst_i,
    input logic [13:0] width_i,
    input logic        crossing_valid_i,
    input logic [31:0] crossing_face_i,
    input logic [13:0] crossing_element_i,
    input logic        crossing_left_i,
    input logic        crossing_end_i,
    input logic        crossing_cut_i,
    input logic        span_ready_i,

    input logic [13:0] at_q,
    input logic [13:0] start_q,
    input logic [ 6:0] shown_q,  // the face; with bit 6 the background
    input logic        valid_q,
    input logic [ 6:0] face_q,
    input logic [13:0] first_q,
    input logic [13:0] end_q,
    input logic        last_q,
    input logic        closing_q,
    input logic        closing_two_q,
    input logic [13:0] closing_first_q,
    input logic [13:0] closing_middle_q,
    input logic [ 6:0] closing_shown_q,
    // The active set's answers.
    input logic        any,
    input logic [ 5:0] first_face,
    input logic        entered,
    input logic        taken_out,
    // And what it is asked.
    input logic        set_clear,
    input logic        set_pass,
    input logic [ 5:0] set_face,
    input logic        set_left,
    output logic       ok_o
);
  localparam logic [6:0] Background = 7'd64;
  logic ready, valid, background, last, mon_entered, mon_taken_out, too_small;
  logic [5:0] face;
  logic [13:0] first, span_end;
  priority_resolver #(.Faces(Faces)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .cfg_width_i(width_i),
      .crossings_valid_i(crossing_valid_i), .crossings_face_i(crossing_face_i),
      .crossings_element_i(crossing_element_i), .crossings_left_i(crossing_left_i),
      .crossings_end_i(crossing_end_i), .crossings_cut_i(crossing_cut_i),
      .crossings_ready_o(ready), .spans_valid_o(valid), .spans_face_o(face),
      .spans_background_o(background), .spans_first_o(first), .spans_end_o(span_end),
      .spans_last_o(last), .spans_ready_i(span_ready_i), .mon_entered_o(mon_entered),
      .mon_taken_out_o(mon_taken_out), .mon_too_small_o(too_small)
  );

  // PR2, PR3.
  logic free, takes, ends, too_large, outputs_ok;
  always_comb begin
    free = span_ready_i || !valid_q;
    takes = crossing_valid_i && free && !closing_q;
    ends = takes && crossing_end_i;
    too_large = takes && !ends && crossing_face_i >= Faces;
    outputs_ok = ready == (free && !closing_q) && valid == valid_q &&
        {background, face} == face_q && first == first_q && span_end == end_q && last == last_q &&
        set_clear == ends && set_pass == (takes && !ends && !too_large) &&
        (!set_pass || {set_face, set_left} == {crossing_face_i[5:0], crossing_left_i});
  end

  // PR4: the answer stands for all up to `at`; where it is new a span ends at `at`.
  logic [13:0] limit, start_now;
  logic [6:0] answer, shown_now;
  logic compare, span_there;
  always_comb begin
    limit = crossing_element_i;
    if (crossing_end_i && !crossing_cut_i) limit = width_i;
    answer = Background;
    if (any) answer = {1'b0, first_face};
    compare = limit > at_q;
    span_there = compare && answer != shown_q && at_q > start_q;
    start_now = start_q;
    shown_now = shown_q;
    if (compare && answer != shown_q) begin
      start_now = at_q;
      shown_now = answer;
    end
  end

  // The spans of the line's end (PR6), in their order, and how many they are.
  logic [34:0] span[3];  // face, first, end
  logic [1:0] spans;
  logic cut_short;
  always_comb begin
    cut_short = limit < width_i && shown_now != Background;
    spans = 2'd0;
    span[0] = '0;
    span[1] = '0;
    span[2] = '0;
    if (span_there) begin
      span[0] = {shown_q, start_q, at_q};
      spans = 2'd1;
    end
    span[spans] = {shown_now, start_now, cut_short ? limit : width_i};
    spans = spans + 2'd1;
    if (cut_short) begin
      span[spans] = {Background, limit, width_i};
      spans = spans + 2'd1;
    end
  end

  // What is seen of the registers after the step. Those that wait to be closed matter only while
  // something waits, and a span only while it is offered.
  logic [13:0] at_n, start_n, closing_first_n, closing_middle_n;
  logic [6:0] shown_n, closing_shown_n;
  logic [34:0] span_n;
  logic valid_n, last_n, closing_n, two_n, entered_n, taken_out_n, too_small_n;
  always_ff @(posedge clk_i) begin
    {at_n, start_n, shown_n} <= {at_q, start_q, shown_q};
    {valid_n, span_n, last_n} <= {valid_q && !span_ready_i, face_q, first_q, end_q, last_q};
    {closing_n, two_n} <= {closing_q, closing_two_q};
    {closing_first_n, closing_middle_n} <= {closing_first_q, closing_middle_q};
    closing_shown_n <= closing_shown_q;
    if (takes && !ends) begin
      {at_n, start_n, shown_n} <= {limit, start_now, shown_now};
      if (span_there) {valid_n, span_n, last_n} <= {1'b1, shown_q, start_q, at_q, 1'b0};
    end else if (ends) begin
      {at_n, start_n, shown_n} <= {14'd0, 14'd0, Background};
      {valid_n, span_n, last_n} <= {1'b1, span[0], spans == 2'd1};
      {closing_n, two_n} <= {spans != 2'd1, spans == 2'd3};
      {closing_shown_n, closing_first_n} <= span[1][34:14];
      closing_middle_n <= limit;
    end else if (closing_q && free) begin
      {valid_n, last_n} <= {1'b1, !closing_two_q};
      span_n <= {closing_shown_q, closing_first_q, closing_two_q ? closing_middle_q : width_i};
      {closing_n, two_n} <= {closing_two_q, 1'b0};
      {closing_shown_n, closing_first_n} <= {Background, closing_middle_q};
    end
    {entered_n, taken_out_n} <= {entered, taken_out};
    too_small_n <= too_small || too_large;
    if (rst_i) begin
      {at_n, start_n, shown_n} <= {14'd0, 14'd0, Background};
      {valid_n, closing_n, two_n} <= 3'd0;
      {entered_n, taken_out_n, too_small_n} <= 3'd0;
    end
  end

  logic before_ok, before_ok_q, registers_ok;
  assign before_ok = (closing_q || !closing_two_q) && (shown_q <= Background) &&
                     at_q <= width_i && start_q <= at_q;
  always_ff @(posedge clk_i) before_ok_q <= before_ok && (!takes || limit <= width_i);
  assign registers_ok = {at_n, start_n, shown_n} == {at_q, start_q, shown_q} &&
      {valid_n, closing_n, two_n} == {valid_q, closing_q, closing_two_q} &&
      (!valid_n || {span_n, last_n} == {face_q, first_q, end_q, last_q}) &&
      (!closing_n || {closing_shown_n, closing_first_n} == {closing_shown_q, closing_first_q}) &&
      (!two_n || closing_middle_n == closing_middle_q) &&
      {entered_n, taken_out_n, too_small_n} == {mon_entered, mon_taken_out, too_small};
  assign ok_o = second_i ? !before_ok_q || registers_ok : outputs_ok;
endmodule
