// SPDX-License-Identifier: MIT
// One row of the separating-object matrix: one object against all of them (Levine 1975, ch. VI.E).
// Words, marks and answers are those of so_pair; object m has bits m * Planes and up of the flat
// rows. `asked_i` chooses the objects that are asked about: without the row's own object, because
// the diagonal is zero, and without those that are not active. That a machine works out a row at a
// time is a reconstruction.
module so_row #(
    parameter int Objects = 64,
    parameter int Planes  = 64
) (
    input  logic [        Planes-1:0] s_l_i,
    input  logic [        Planes-1:0] r_l_i,
    input  logic [Objects*Planes-1:0] s_i,
    input  logic [Objects*Planes-1:0] r_i,
    input  logic [       Objects-1:0] asked_i,
    output logic [       Objects-1:0] hides_o,
    output logic [       Objects-1:0] hidden_o,
    output logic [       Objects-1:0] unresolved_o
);
  logic [Objects-1:0] hides, hidden, unresolved;

  for (genvar m = 0; m < Objects; m++) begin : g_pair
    so_pair #(
        .Planes(Planes)
    ) u_pair (
        .s_l_i       (s_l_i),
        .r_l_i       (r_l_i),
        .s_m_i       (s_i[m*Planes+:Planes]),
        .r_m_i       (r_i[m*Planes+:Planes]),
        .hides_o     (hides[m]),
        .hidden_o    (hidden[m]),
        .unresolved_o(unresolved[m])
    );
  end

  assign hides_o = hides & asked_i;
  assign hidden_o = hidden & asked_i;
  assign unresolved_o = unresolved & asked_i;
endmodule
