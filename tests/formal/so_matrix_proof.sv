// SPDX-License-Identifier: MIT
// Every bit of so_matrix is the answer of so_pair; the diagonal is zero; the matrix is
// anti-symmetric.
module so_matrix_proof #(
    parameter int Objects = 5,
    parameter int Planes = 4,
    localparam int IndexWidth = $clog2(Objects)
) (
    input  logic [Objects*Planes-1:0] s_i,
    input  logic [Objects*Planes-1:0] r_i,
    input  logic [    IndexWidth-1:0] l_i,
    input  logic [    IndexWidth-1:0] m_i,
    output logic                      ok_o
);
  logic [Objects*Objects-1:0] hides, hidden, unresolved;
  so_matrix #(.Objects(Objects), .Planes(Planes)) u_matrix (
      .s_i(s_i), .r_i(r_i), .hides_o(hides), .hidden_o(hidden), .unresolved_o(unresolved)
  );
  logic pair_hides, pair_hidden, pair_unresolved;
  so_pair #(.Planes(Planes)) u_pair (
      .s_l_i(s_i[l_i*Planes+:Planes]), .r_l_i(r_i[l_i*Planes+:Planes]),
      .s_m_i(s_i[m_i*Planes+:Planes]), .r_m_i(r_i[m_i*Planes+:Planes]),
      .hides_o(pair_hides), .hidden_o(pair_hidden), .unresolved_o(pair_unresolved)
  );
  logic this_hides, this_hidden, this_unresolved;
  assign this_hides = hides[l_i*Objects+m_i];
  assign this_hidden = hidden[l_i*Objects+m_i];
  assign this_unresolved = unresolved[l_i*Objects+m_i];

  assign ok_o = l_i >= Objects || m_i >= Objects ||
                (l_i == m_i ? !this_hides && !this_hidden && !this_unresolved
                            : this_hides == pair_hides && this_hidden == pair_hidden &&
                              this_unresolved == pair_unresolved &&
                              this_hides == hidden[m_i*Objects+l_i] &&
                              this_unresolved == unresolved[m_i*Objects+l_i]);
endmodule
