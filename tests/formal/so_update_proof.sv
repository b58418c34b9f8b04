// SPDX-License-Identifier: MIT
// so_update from reset on: whenever it is ready, its answers are those of so_row worked out anew,
// for the planes whose sides were told, whatever came in before.
module so_update_proof #(
    parameter int Objects = 2,
    parameter int Planes = 2,
    localparam int ObjectWidth = $clog2(Objects),
    localparam int PlaneWidth = $clog2(Planes)
) (
    input  logic                   clk_i,
    input  logic                   rst_i,
    input  logic                   clear_i,
    input  logic                   column_valid_i,
    input  logic [ PlaneWidth-1:0] column_plane_i,
    input  logic [    Objects-1:0] column_tells_i,
    input  logic [    Objects-1:0] column_plus_i,
    input  logic                   side_valid_i,
    input  logic [ PlaneWidth-1:0] side_plane_i,
    input  logic                   side_plus_i,
    input  logic [ObjectWidth-1:0] row_i,
    output logic                   ok_o
);
  // SEPL by rows, the eye, and which planes have begun to count.
  logic [Objects*Planes-1:0] tells_q, plus_q, s, r;
  logic [Planes-1:0] written_q, known_q, eye_q;

  // The contracts: SEPL is written while ready, and not to planes whose side was told; sides are
  // told of planes that were written.
  logic ready, clear, column, side;
  logic [Objects-1:0] hides, hidden, unresolved;
  assign clear = clear_i && ready;
  assign column = column_valid_i && ready && !clear && !known_q[column_plane_i];
  assign side = side_valid_i && written_q[side_plane_i] &&
                !(column && column_plane_i == side_plane_i);
  so_update #(.Objects(Objects), .Planes(Planes)) u_update (
      .clk_i(clk_i), .rst_i(rst_i), .clear_i(clear),
      .column_valid_i(column), .column_plane_i(column_plane_i),
      .column_tells_i(column_tells_i), .column_plus_i(column_plus_i),
      .side_valid_i(side), .side_ready_o(ready), .side_plane_i(side_plane_i),
      .side_plus_i(side_plus_i),
      .row_i(row_i), .row_hides_o(hides), .row_hidden_o(hidden), .row_unresolved_o(unresolved)
  );

  always_ff @(posedge clk_i) begin
    if (column)
      for (int o = 0; o < Objects; o++) begin
        tells_q[o*Planes+column_plane_i] <= column_tells_i[o];
        plus_q[o*Planes+column_plane_i]  <= column_plus_i[o];
      end
    if (rst_i) written_q <= '0;
    else if (column) written_q[column_plane_i] <= 1'b1;
    if (rst_i || clear) known_q <= '0;
    else if (side && ready) begin
      known_q[side_plane_i] <= 1'b1;
      eye_q[side_plane_i]   <= side_plus_i;
    end
  end
  assign s = tells_q & {Objects{known_q}};
  assign r = s & ~(plus_q ^ {Objects{eye_q}});

  logic [Objects-1:0] row_hides, row_hidden, row_unresolved;
  so_row #(.Objects(Objects), .Planes(Planes)) u_row (
      .s_l_i(s[row_i*Planes+:Planes]), .r_l_i(r[row_i*Planes+:Planes]), .s_i(s), .r_i(r),
      .asked_i(~({{(Objects - 1) {1'b0}}, 1'b1} << row_i)),
      .hides_o(row_hides), .hidden_o(row_hidden), .unresolved_o(row_unresolved)
  );
  assign ok_o = rst_i || !ready || row_i >= Objects ||
                (hides == row_hides && hidden == row_hidden && unresolved == row_unresolved);
endmodule
