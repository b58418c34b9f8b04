// SPDX-License-Identifier: MIT
// The separating-object matrix (Levine 1975, ch. VI.E) in incremental form: it stands in memory as
// counts (so_count.sv), and an eye that crosses a plane changes only the pairs which that plane
// parts. A crossing costs one cycle and one for each object that the plane tells of; an eye that
// crosses nothing costs nothing. State: two counts a pair, so that a row is read and changed by
// itself, and SEPL by columns, because a crossing is about one plane. All of this machine is a
// reconstruction.
//
// SEPL: clear_i forgets everything; a column is written with column_valid_i. Both while ready.
// Sides: side_valid_i is held until side_ready_o, and tells on which side of one plane the eye is
// now; the first time after clear_i the plane begins to count. Planes that were never told of part
// nobody.
// Answers: those of row_i, in the same cycle, as in so_row; they stand while side_ready_o is set.
`include "rtl/common/assertions.svh"

module so_update #(
    parameter int Objects = 64,  // 2 or more
    parameter int Planes = 64,  // 2 or more
    localparam int ObjectWidth = $clog2(Objects),
    localparam int PlaneWidth = $clog2(Planes)
) (
    input logic clk_i,
    input logic rst_i,

    input logic                  clear_i,
    input logic                  column_valid_i,
    input logic [PlaneWidth-1:0] column_plane_i,
    input logic [   Objects-1:0] column_tells_i,
    input logic [   Objects-1:0] column_plus_i,

    input  logic                  side_valid_i,
    output logic                  side_ready_o,
    input  logic [PlaneWidth-1:0] side_plane_i,
    input  logic                  side_plus_i,   // the eye is on the plus side

    input  logic [ObjectWidth-1:0] row_i,
    output logic [    Objects-1:0] row_hides_o,
    output logic [    Objects-1:0] row_hidden_o,
    output logic [    Objects-1:0] row_unresolved_o
);
  localparam int CountWidth = $clog2(Planes + 1);
  localparam int RowWidth = Objects * CountWidth;
  localparam logic [Objects-1:0] One = {{(Objects - 1) {1'b0}}, 1'b1};

  logic [Objects-1:0] tells_q[Planes];
  logic [Objects-1:0] plus_q [Planes];

  always_ff @(posedge clk_i) begin
    if (column_valid_i) begin
      tells_q[column_plane_i] <= column_tells_i;
      plus_q[column_plane_i]  <= column_plus_i;
    end
  end

  // The plane that the eye crosses, and the rows that are still to be changed.
  logic [Objects-1:0] pending_q, crossed_tells_q, crossed_near_q;
  logic crossed_known_q;
  logic [Planes-1:0] known_q, eye_q;  // planes that count, and the eye's sides of them
  logic side, news;

  assign side_ready_o = pending_q == '0;
  assign side = side_valid_i && side_ready_o && !clear_i;
  assign news = side && !(known_q[side_plane_i] && eye_q[side_plane_i] == side_plus_i);

  logic updating;
  logic [ObjectWidth-1:0] row;
  logic [Objects-1:0] row_bit;
  first_set #(
      .Width(Objects)
  ) u_row (
      .bits_i (pending_q),
      .any_o  (updating),
      .index_o(row)
  );
  assign row_bit = updating ? One << row : '0;

  always_ff @(posedge clk_i) begin
    if (rst_i || clear_i) known_q <= '0;
    else if (news) known_q[side_plane_i] <= 1'b1;
    if (news) eye_q[side_plane_i] <= side_plus_i;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) pending_q <= '0;
    else if (news) pending_q <= tells_q[side_plane_i];
    else pending_q <= pending_q & ~row_bit;
    if (news) begin
      crossed_known_q <= known_q[side_plane_i];
      crossed_tells_q <= tells_q[side_plane_i];
      crossed_near_q  <= ~(plus_q[side_plane_i] ^ {Objects{side_plus_i}});
    end
  end

  // Counts: word m of row l is about l and m. Rows that were not written since clear_i are zero.
  logic [RowWidth-1:0] nearer_q [Objects];  // planes with l on the near side and m beyond
  logic [RowWidth-1:0] farther_q[Objects];
  logic [Objects-1:0] written_q;
  logic [RowWidth-1:0] nearer, farther, nearer_d, farther_d;

  assign nearer = written_q[row] ? nearer_q[row] : '0;
  assign farther = written_q[row] ? farther_q[row] : '0;

  for (genvar m = 0; m < Objects; m++) begin : g_count
    so_count #(
        .Planes(Planes)
    ) u_count (
        .known_i   (crossed_known_q),
        .tells_l_i (crossed_tells_q[row]),
        .near_l_i  (crossed_near_q[row]),
        .tells_m_i (crossed_tells_q[m]),
        .near_m_i  (crossed_near_q[m]),
        .nearer_l_i(nearer[m*CountWidth+:CountWidth]),
        .nearer_m_i(farther[m*CountWidth+:CountWidth]),
        .nearer_l_o(nearer_d[m*CountWidth+:CountWidth]),
        .nearer_m_o(farther_d[m*CountWidth+:CountWidth])
    );
  end

  always_ff @(posedge clk_i) begin
    if (updating) begin
      nearer_q[row]  <= nearer_d;
      farther_q[row] <= farther_d;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i || clear_i) written_q <= '0;
    else written_q <= written_q | row_bit;
  end

  logic [RowWidth-1:0] read_nearer, read_farther;
  logic [Objects-1:0] l_nearer, m_nearer;
  assign read_nearer = written_q[row_i] ? nearer_q[row_i] : '0;
  assign read_farther = written_q[row_i] ? farther_q[row_i] : '0;

  for (genvar m = 0; m < Objects; m++) begin : g_answer
    assign l_nearer[m] = |read_nearer[m*CountWidth+:CountWidth];
    assign m_nearer[m] = |read_farther[m*CountWidth+:CountWidth];
  end
  assign row_hides_o = l_nearer & ~m_nearer;
  assign row_hidden_o = m_nearer & ~l_nearer;
  assign row_unresolved_o = ~(l_nearer | m_nearer) & ~(One << row_i);

  `CIGSIM_ASSERT(SeplChangesWhileReady, side_ready_o || !(clear_i || column_valid_i))
  `CIGSIM_ASSERT(TheDiagonalIsZero, !(|((row_hides_o | row_hidden_o) & (One << row_i))))
endmodule
