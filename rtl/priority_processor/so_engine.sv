// SPDX-License-Identifier: MIT
// The separating-object matrix as a machine (Levine 1975, ch. VI.E): SEPL is kept in registers, is
// marked for an eyepoint, and one row of the matrix comes out a cycle, with the object's count, the
// number of objects that may hide it. With the last row come the checks of a priority list: the
// counts are a permutation of 0 .. n-1 (Stump 1986 asks the same of his counters), and every pair
// has an answer. Matrix and marks: published. Registers, pins and cycles: reconstruction.
//
// SEPL: a row is written in a cycle with row_valid_i, while nothing is being answered. `tells`: the
// plane lies to one side of the object; `plus`: the object is on the plane's plus side, and counts
// only where `tells` is set.
// Eye: start_valid_i is held until start_ready_o; a bit a plane, set where the eye is on the plus
// side. Ready is told while nothing is being answered, and with the last row.
// Answers: row 0 in the cycle after the start, then a row a cycle up to cfg_last_row_i. The rows of
// objects that are not active are told too, with nothing in them.
`include "rtl/common/assertions.svh"

module so_engine #(
    parameter int Objects = 64,  // 2 or more
    parameter int Planes = 64,
    localparam int IndexWidth = $clog2(Objects)
) (
    input logic clk_i,
    input logic rst_i,

    input logic [IndexWidth-1:0] cfg_last_row_i,  // number of objects, less one

    input logic                  row_valid_i,
    input logic [IndexWidth-1:0] row_index_i,
    input logic [    Planes-1:0] row_tells_i,
    input logic [    Planes-1:0] row_plus_i,

    input  logic               start_valid_i,
    output logic               start_ready_o,
    input  logic [ Planes-1:0] start_eye_i,
    input  logic [Objects-1:0] start_active_i,

    output logic                  answer_valid_o,
    output logic [IndexWidth-1:0] answer_row_o,
    output logic [   Objects-1:0] answer_hides_o,
    output logic [   Objects-1:0] answer_hidden_o,
    output logic [   Objects-1:0] answer_unresolved_o,
    output logic [IndexWidth-1:0] answer_count_o,
    output logic                  answer_last_o,
    output logic                  answer_unique_o,     // with the last row: no count came twice
    output logic                  answer_resolved_o    // with the last row: no pair is unresolved
);
  logic [Planes-1:0] tells_q[Objects];
  logic [Planes-1:0] plus_q [Objects];

  always_ff @(posedge clk_i) begin
    if (row_valid_i) begin
      tells_q[row_index_i] <= row_tells_i;
      plus_q[row_index_i]  <= row_plus_i;
    end
  end

  logic busy_q;
  logic [IndexWidth-1:0] row_q;
  logic [Planes-1:0] eye_q;
  logic [Objects-1:0] active_q;
  logic start, last;

  assign last = busy_q && row_q == cfg_last_row_i;
  assign start_ready_o = !busy_q || last;
  assign start = start_valid_i && start_ready_o;

  // Marks: an object is on the eye's side where its sign is the eye's.
  logic [Objects*Planes-1:0] s, r;
  always_comb begin
    for (int m = 0; m < Objects; m++) begin
      s[m*Planes+:Planes] = tells_q[m];
      r[m*Planes+:Planes] = tells_q[m] & ~(plus_q[m] ^ eye_q);
    end
  end

  logic [Planes-1:0] s_l, r_l;
  assign s_l = tells_q[row_q];
  assign r_l = s_l & ~(plus_q[row_q] ^ eye_q);

  logic row_active;
  logic [Objects-1:0] self, asked;
  assign self = {{(Objects - 1) {1'b0}}, 1'b1} << row_q;
  assign row_active = busy_q && |(active_q & self);
  assign asked = row_active ? active_q & ~self : '0;

  logic [Objects-1:0] hides, hidden, unresolved;
  so_row #(
      .Objects(Objects),
      .Planes (Planes)
  ) u_row (
      .s_l_i       (s_l),
      .r_l_i       (r_l),
      .s_i         (s),
      .r_i         (r),
      .asked_i     (asked),
      .hides_o     (hides),
      .hidden_o    (hidden),
      .unresolved_o(unresolved)
  );

  logic [IndexWidth-1:0] count;
  always_comb begin
    count = '0;
    for (int m = 0; m < Objects; m++) count = count + IndexWidth'(hidden[m]);
  end

  // Counts are at most n - 1, so that n of them without a repetition are a permutation.
  logic [Objects-1:0] seen_q, seen_d;
  logic repeated_q, repeated_d, unresolved_q, unresolved_d;
  always_comb begin
    seen_d = seen_q;
    repeated_d = repeated_q;
    unresolved_d = unresolved_q || |unresolved;
    if (row_active) begin
      repeated_d = repeated_q || seen_q[count];
      seen_d[count] = 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) busy_q <= 1'b0;
    else if (start) busy_q <= 1'b1;
    else if (last) busy_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (start) begin
      row_q <= '0;
      eye_q <= start_eye_i;
      active_q <= start_active_i;
      seen_q <= '0;
      repeated_q <= 1'b0;
      unresolved_q <= 1'b0;
    end else if (busy_q) begin
      row_q <= row_q + IndexWidth'(1);
      seen_q <= seen_d;
      repeated_q <= repeated_d;
      unresolved_q <= unresolved_d;
    end
  end

  assign answer_valid_o = busy_q;
  assign answer_row_o = busy_q ? row_q : '0;
  assign answer_hides_o = hides;
  assign answer_hidden_o = hidden;
  assign answer_unresolved_o = unresolved;
  assign answer_count_o = count;
  assign answer_last_o = last;
  assign answer_unique_o = last && !repeated_d;
  assign answer_resolved_o = last && !unresolved_d;

  `CIGSIM_ASSERT(RowsAreWrittenWhileNothingIsAnswered, !(row_valid_i && busy_q))
  `CIGSIM_ASSERT(AnswersExcludeEachOther,
                 !(|(hides & hidden)) && !(|((hides | hidden) & unresolved)))
  `CIGSIM_ASSERT(TheDiagonalIsZero, !(|((hides | hidden | unresolved) & self)))
endmodule
