// SPDX-License-Identifier: MIT
// One step of so_engine from any values in its registers: a row of the matrix told plane by plane
// (Levine 1975, ch. VI.E), its count, and what is kept for the checks of the list.
// registers: tells_q[ObjectsxPlanes] plus_q[ObjectsxPlanes] busy_q row_q eye_q active_q seen_q repeated_q unresolved_q
module so_engine_proof #(
    parameter int Objects = 16,
    parameter int Planes = 16,
    localparam int IndexWidth = $clog2(Objects)
) (
    input logic                  clk_i,
    input logic                  second_i,
    input logic                  rst_i,
    input logic [IndexWidth-1:0] last_row_i,
    input logic                  write_i,
    input logic [IndexWidth-1:0] index_i,
    input logic [    Planes-1:0] tells_i,
    input logic [    Planes-1:0] plus_i,
    input logic                  start_i,
    input logic [    Planes-1:0] eye_i,
    input logic [   Objects-1:0] active_i,

    input logic [Objects*Planes-1:0] tells_q,
    input logic [Objects*Planes-1:0] plus_q,
    input logic                      busy_q,
    input logic [    IndexWidth-1:0] row_q,
    input logic [        Planes-1:0] eye_q,
    input logic [       Objects-1:0] active_q,
    input logic [       Objects-1:0] seen_q,
    input logic                      repeated_q,
    input logic                      unresolved_q,
    output logic                     ok_o
);
  logic ready, valid, last, unique_counts, resolved;
  logic [IndexWidth-1:0] row, count;
  logic [Objects-1:0] hides, hidden, unresolved;
  so_engine #(.Objects(Objects), .Planes(Planes)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .cfg_last_row_i(last_row_i), .row_valid_i(write_i),
      .row_index_i(index_i), .row_tells_i(tells_i), .row_plus_i(plus_i), .start_valid_i(start_i),
      .start_ready_o(ready), .start_eye_i(eye_i), .start_active_i(active_i),
      .answer_valid_o(valid), .answer_row_o(row), .answer_hides_o(hides),
      .answer_hidden_o(hidden), .answer_unresolved_o(unresolved), .answer_count_o(count),
      .answer_last_o(last), .answer_unique_o(unique_counts), .answer_resolved_o(resolved)
  );

  // The row's object against each other one: whether a plane has it nearer, or the other.
  logic [Planes-1:0] tells_l, plus_l;
  logic [Objects-1:0] hides_d, hidden_d, unresolved_d;
  logic [IndexWidth-1:0] count_d;
  logic l_there, nearer, farther;
  always_comb begin
    tells_l = '0;
    plus_l = '0;
    l_there = 1'b0;
    for (int o = 0; o < Objects; o++)
      if (row_q == o) begin
        tells_l = tells_q[o*Planes+:Planes];
        plus_l = plus_q[o*Planes+:Planes];
        l_there = busy_q && active_q[o];
      end
    hides_d = '0;
    hidden_d = '0;
    unresolved_d = '0;
    count_d = '0;
    nearer = 1'b0;
    farther = 1'b0;
    for (int o = 0; o < Objects; o++)
      if (l_there && row_q != o && active_q[o]) begin
        nearer = 1'b0;
        farther = 1'b0;
        for (int p = 0; p < Planes; p++)
          if (tells_l[p] && tells_q[o*Planes+p] && plus_l[p] != plus_q[o*Planes+p]) begin
            if (plus_l[p] == eye_q[p]) nearer = 1'b1;
            else farther = 1'b1;
          end
        if (nearer && !farther) hides_d[o] = 1'b1;
        if (farther && !nearer) begin
          hidden_d[o] = 1'b1;
          count_d = count_d + 1'b1;
        end
        if (!nearer && !farther) unresolved_d[o] = 1'b1;
      end
  end

  logic is_last, ready_d, again, missing, outputs_ok;
  always_comb begin
    is_last = busy_q && row_q == last_row_i;
    ready_d = is_last || !busy_q;
    again = repeated_q;
    for (int n = 0; n < Objects; n++) if (l_there && count_d == n && seen_q[n]) again = 1'b1;
    missing = unresolved_q || unresolved_d != 0;
    outputs_ok = ready == ready_d && valid == busy_q && row == (busy_q ? row_q : 0) &&
        hides == hides_d && hidden == hidden_d && unresolved == unresolved_d &&
        count == count_d && last == is_last && unique_counts == (is_last && !again) &&
        resolved == (is_last && !missing);
  end

  logic [Objects*Planes-1:0] tells_n, plus_n;
  logic busy_n, repeated_n, unresolved_n;
  logic [IndexWidth-1:0] row_n;
  logic [Planes-1:0] eye_n;
  logic [Objects-1:0] active_n, seen_n;
  always_ff @(posedge clk_i) begin
    {tells_n, plus_n} <= {tells_q, plus_q};
    for (int o = 0; o < Objects; o++)
      if (write_i && index_i == o) begin
        tells_n[o*Planes+:Planes] <= tells_i;
        plus_n[o*Planes+:Planes]  <= plus_i;
      end
    {busy_n, row_n, eye_n, active_n} <= {busy_q && !is_last, row_q, eye_q, active_q};
    {seen_n, repeated_n, unresolved_n} <= {seen_q, repeated_q, unresolved_q};
    if (busy_q) begin
      row_n <= row_q + 1'b1;
      for (int n = 0; n < Objects; n++) if (l_there && count_d == n) seen_n[n] <= 1'b1;
      {repeated_n, unresolved_n} <= {again, missing};
    end
    if (start_i && ready_d) begin
      {busy_n, row_n, eye_n, active_n} <= {1'b1, {IndexWidth{1'b0}}, eye_i, active_i};
      {seen_n, repeated_n, unresolved_n} <= '0;
    end
    if (rst_i) busy_n <= 1'b0;
  end
  assign ok_o = second_i
      ? {tells_n, plus_n, busy_n, row_n, eye_n, active_n, seen_n, repeated_n, unresolved_n} ==
        {tells_q, plus_q, busy_q, row_q, eye_q, active_q, seen_q, repeated_q, unresolved_q}
      : outputs_ok;
endmodule
