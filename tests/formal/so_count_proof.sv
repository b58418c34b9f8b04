// SPDX-License-Identifier: MIT
// One step from any consistent state: counts that are those of the planes told of so far are, after
// any crossing, those of the planes told of then, and give the answers of so_pair worked out anew.
// With counts of zero where no plane was told of, this is an induction over the crossings.
module so_count_proof #(
    parameter int Planes = 16,
    localparam int CountWidth = $clog2(Planes + 1),
    localparam int PlaneWidth = $clog2(Planes)
) (
    input  logic [    Planes-1:0] s_l_i,
    input  logic [    Planes-1:0] r_l_i,
    input  logic [    Planes-1:0] s_m_i,
    input  logic [    Planes-1:0] r_m_i,
    input  logic [    Planes-1:0] known_i,    // planes told of before
    input  logic [PlaneWidth-1:0] crossed_i,
    output logic                  ok_o
);
  function automatic logic [CountWidth-1:0] nearer(input logic [Planes-1:0] s_a, r_a, s_b, r_b);
    nearer = '0;
    for (int n = 0; n < Planes; n++)
      if (s_a[n] && r_a[n] && s_b[n] && !r_b[n]) nearer = nearer + CountWidth'(1);
  endfunction

  // Before: without the plane, or with the eye on its other side.
  logic [Planes-1:0] crossed, after;
  logic known;
  assign crossed = {{(Planes - 1) {1'b0}}, 1'b1} << crossed_i;
  assign known = known_i[crossed_i];
  assign after = known_i | crossed;

  logic [CountWidth-1:0] nearer_l, nearer_m, new_l, new_m;
  assign nearer_l = nearer(s_l_i & known_i, r_l_i ^ crossed, s_m_i & known_i, r_m_i ^ crossed);
  assign nearer_m = nearer(s_m_i & known_i, r_m_i ^ crossed, s_l_i & known_i, r_l_i ^ crossed);

  so_count #(.Planes(Planes)) u_count (
      .known_i(known),
      .tells_l_i(s_l_i[crossed_i]), .near_l_i(r_l_i[crossed_i]),
      .tells_m_i(s_m_i[crossed_i]), .near_m_i(r_m_i[crossed_i]),
      .nearer_l_i(nearer_l), .nearer_m_i(nearer_m),
      .nearer_l_o(new_l), .nearer_m_o(new_m)
  );

  logic hides, hidden, unresolved;
  so_pair #(.Planes(Planes)) u_pair (
      .s_l_i(s_l_i & after), .r_l_i(r_l_i), .s_m_i(s_m_i & after), .r_m_i(r_m_i),
      .hides_o(hides), .hidden_o(hidden), .unresolved_o(unresolved)
  );

  assign ok_o = crossed_i >= Planes ||
                (new_l == nearer(s_l_i & after, r_l_i, s_m_i & after, r_m_i) &&
                 new_m == nearer(s_m_i & after, r_m_i, s_l_i & after, r_l_i) &&
                 hides == (new_l != '0 && new_m == '0) &&
                 hidden == (new_m != '0 && new_l == '0) &&
                 unresolved == (new_l == '0 && new_m == '0));
endmodule
