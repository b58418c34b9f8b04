// SPDX-License-Identifier: MIT
// Every bit of so_row is the answer of so_pair where it is asked for, and zero elsewhere.
module so_row_proof #(
    parameter int Objects = 16,
    parameter int Planes = 16,
    localparam int IndexWidth = $clog2(Objects)
) (
    input  logic [        Planes-1:0] s_l_i,
    input  logic [        Planes-1:0] r_l_i,
    input  logic [Objects*Planes-1:0] s_i,
    input  logic [Objects*Planes-1:0] r_i,
    input  logic [       Objects-1:0] asked_i,
    input  logic [    IndexWidth-1:0] m_i,
    output logic                      ok_o
);
  logic [Objects-1:0] hides, hidden, unresolved;
  so_row #(.Objects(Objects), .Planes(Planes)) u_row (
      .s_l_i(s_l_i), .r_l_i(r_l_i), .s_i(s_i), .r_i(r_i), .asked_i(asked_i),
      .hides_o(hides), .hidden_o(hidden), .unresolved_o(unresolved)
  );
  logic pair_hides, pair_hidden, pair_unresolved, asked;
  so_pair #(.Planes(Planes)) u_pair (
      .s_l_i(s_l_i), .r_l_i(r_l_i), .s_m_i(s_i[m_i*Planes+:Planes]),
      .r_m_i(r_i[m_i*Planes+:Planes]),
      .hides_o(pair_hides), .hidden_o(pair_hidden), .unresolved_o(pair_unresolved)
  );
  assign asked = asked_i[m_i];
  assign ok_o = m_i >= Objects ||
                (hides[m_i] == (asked & pair_hides) && hidden[m_i] == (asked & pair_hidden) &&
                 unresolved[m_i] == (asked & pair_unresolved));
endmodule
