// SPDX-License-Identifier: MIT
// One step of so_update from any values in its registers: SEPL by columns, the plane that is
// crossed, and the counts of each pair, one row a cycle. (so_update_proof.sv proves of the whole
// machine, from reset on, that its answers are those of the matrix.)
// registers: tells_q[PlanesxObjects] plus_q[PlanesxObjects] pending_q crossed_tells_q crossed_near_q crossed_known_q known_q eye_q written_q nearer_q[ObjectsxObjects*CountWidth] farther_q[ObjectsxObjects*CountWidth]
module so_update_step_proof #(
    parameter int Objects = 16,
    parameter int Planes = 16,
    parameter int CountWidth = 5,  // of numbers up to Planes
    localparam int ObjectWidth = $clog2(Objects),
    localparam int PlaneWidth = $clog2(Planes),
    localparam int RowWidth = Objects * CountWidth
) (
    input logic                   clk_i,
    input logic                   second_i,
    input logic                   rst_i,
    input logic                   clear_i,
    input logic                   column_i,
    input logic [ PlaneWidth-1:0] column_plane_i,
    input logic [    Objects-1:0] column_tells_i,
    input logic [    Objects-1:0] column_plus_i,
    input logic                   side_i,
    input logic [ PlaneWidth-1:0] side_plane_i,
    input logic                   side_plus_i,
    input logic [ObjectWidth-1:0] row_i,

    input logic [  Planes*Objects-1:0] tells_q,
    input logic [  Planes*Objects-1:0] plus_q,
    input logic [         Objects-1:0] pending_q,
    input logic [         Objects-1:0] crossed_tells_q,
    input logic [         Objects-1:0] crossed_near_q,
    input logic                        crossed_known_q,
    input logic [          Planes-1:0] known_q,
    input logic [          Planes-1:0] eye_q,
    input logic [         Objects-1:0] written_q,
    input logic [Objects*RowWidth-1:0] nearer_q,
    input logic [Objects*RowWidth-1:0] farther_q,
    output logic                       ok_o
);
  logic ready;
  logic [Objects-1:0] hides, hidden, unresolved;
  so_update #(.Objects(Objects), .Planes(Planes)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .clear_i(clear_i), .column_valid_i(column_i),
      .column_plane_i(column_plane_i), .column_tells_i(column_tells_i),
      .column_plus_i(column_plus_i), .side_valid_i(side_i), .side_ready_o(ready),
      .side_plane_i(side_plane_i), .side_plus_i(side_plus_i), .row_i(row_i),
      .row_hides_o(hides), .row_hidden_o(hidden), .row_unresolved_o(unresolved)
  );

  // The answers of a row are told by whether its counts are zero.
  logic outputs_ok;
  logic [CountWidth-1:0] n, f;
  always_comb begin
    outputs_ok = ready == (pending_q == 0);
    n = '0;
    f = '0;
    for (int l = 0; l < Objects; l++)
      if (row_i == l)
        for (int m = 0; m < Objects; m++) begin
          n = written_q[l] ? nearer_q[l*RowWidth+m*CountWidth+:CountWidth] : 0;
          f = written_q[l] ? farther_q[l*RowWidth+m*CountWidth+:CountWidth] : 0;
          if (hides[m] != (n != 0 && f == 0)) outputs_ok = 1'b0;
          if (hidden[m] != (n == 0 && f != 0)) outputs_ok = 1'b0;
          if (unresolved[m] != (n == 0 && f == 0 && l != m)) outputs_ok = 1'b0;
        end
  end

  // The crossed plane as it is known, and whether what is told is new.
  logic news, known, before_first;
  logic [Objects-1:0] tells, plus;
  always_comb begin
    known = 1'b0;
    news = 1'b0;
    tells = '0;
    plus = '0;
    for (int p = 0; p < Planes; p++)
      if (side_plane_i == p) begin
        known = known_q[p];
        tells = tells_q[p*Objects+:Objects];
        plus = plus_q[p*Objects+:Objects];
        news = side_i && pending_q == 0 && !clear_i && !(known_q[p] && eye_q[p] == side_plus_i);
      end
  end

  logic [Planes*Objects-1:0] tells_n, plus_n;
  logic [Objects-1:0] pending_d, written_d, pending_n, crossed_tells_n, crossed_near_n, written_n;
  logic crossed_known_n;
  logic [Planes-1:0] known_n, eye_n;
  logic [Objects*RowWidth-1:0] nearer_d, farther_d, nearer_n, farther_n;
  logic [CountWidth-1:0] a, b;
  always_comb begin
    {nearer_d, farther_d} = {nearer_q, farther_q};
    pending_d = pending_q;
    written_d = written_q;
    before_first = 1'b1;
    a = '0;
    b = '0;
    for (int l = 0; l < Objects; l++)
      if (pending_q[l] && before_first) begin
        // The first row that waits: each pair that the plane parts gains it on one side, and loses
        // it on the other, if it was counted there.
        before_first = 1'b0;
        pending_d[l] = 1'b0;
        written_d[l] = 1'b1;
        for (int m = 0; m < Objects; m++) begin
          a = written_q[l] ? nearer_q[l*RowWidth+m*CountWidth+:CountWidth] : 0;
          b = written_q[l] ? farther_q[l*RowWidth+m*CountWidth+:CountWidth] : 0;
          if (crossed_tells_q[l] && crossed_tells_q[m] && crossed_near_q[l] != crossed_near_q[m])
            case ({crossed_near_q[l], crossed_known_q})
              2'b10: a = a + 1'b1;
              2'b11: {a, b} = {a + 1'b1, b - 1'b1};
              2'b00: b = b + 1'b1;
              default: {a, b} = {a - 1'b1, b + 1'b1};
            endcase
          nearer_d[l*RowWidth+m*CountWidth+:CountWidth] = a;
          farther_d[l*RowWidth+m*CountWidth+:CountWidth] = b;
        end
      end
  end
  always_ff @(posedge clk_i) begin
    {tells_n, plus_n, known_n, eye_n} <= {tells_q, plus_q, known_q, eye_q};
    {crossed_tells_n, crossed_near_n} <= {crossed_tells_q, crossed_near_q};
    crossed_known_n <= crossed_known_q;
    {nearer_n, farther_n, pending_n, written_n} <= {nearer_d, farther_d, pending_d, written_d};
    for (int p = 0; p < Planes; p++) begin
      if (column_i && column_plane_i == p) begin
        tells_n[p*Objects+:Objects] <= column_tells_i;
        plus_n[p*Objects+:Objects]  <= column_plus_i;
      end
      if (news && side_plane_i == p) {known_n[p], eye_n[p]} <= {1'b1, side_plus_i};
    end
    if (news) begin
      {pending_n, crossed_tells_n, crossed_known_n} <= {tells, tells, known};
      crossed_near_n <= side_plus_i ? plus : ~plus;
    end
    if (clear_i || rst_i) {known_n, written_n} <= '0;
    if (rst_i) pending_n <= '0;
  end
  assign ok_o = second_i
      ? {tells_n, plus_n, pending_n, crossed_tells_n, crossed_near_n, crossed_known_n, known_n,
         eye_n, written_n, nearer_n, farther_n} ==
        {tells_q, plus_q, pending_q, crossed_tells_q, crossed_near_q, crossed_known_q, known_q,
         eye_q, written_q, nearer_q, farther_q}
      : outputs_ok;
endmodule
