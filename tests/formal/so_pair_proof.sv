// SPDX-License-Identifier: MIT
// so_pair is the matrix told plane by plane (Levine 1975, ch. VI.E), for all inputs; answers
// exclude each other; the matrix is anti-symmetric; an object neither hides itself nor is hidden.
module so_pair_proof #(
    parameter int Planes = 64
) (
    input  logic [Planes-1:0] s_l_i,
    input  logic [Planes-1:0] r_l_i,
    input  logic [Planes-1:0] s_m_i,
    input  logic [Planes-1:0] r_m_i,
    output logic              ok_o
);
  logic hides, hidden, unresolved;
  so_pair #(.Planes(Planes)) u_pair (
      .s_l_i(s_l_i), .r_l_i(r_l_i), .s_m_i(s_m_i), .r_m_i(r_m_i),
      .hides_o(hides), .hidden_o(hidden), .unresolved_o(unresolved)
  );
  logic turned_hides, turned_hidden, turned_unresolved;
  so_pair #(.Planes(Planes)) u_turned (
      .s_l_i(s_m_i), .r_l_i(r_m_i), .s_m_i(s_l_i), .r_m_i(r_l_i),
      .hides_o(turned_hides), .hidden_o(turned_hidden), .unresolved_o(turned_unresolved)
  );
  logic self_hides, self_hidden, self_unresolved;
  so_pair #(.Planes(Planes)) u_self (
      .s_l_i(s_l_i), .r_l_i(r_l_i), .s_m_i(s_l_i), .r_m_i(r_l_i),
      .hides_o(self_hides), .hidden_o(self_hidden), .unresolved_o(self_unresolved)
  );

  // Plane by plane: 0 nothing yet, 1 l may hide m, 2 m may hide l, 3 both, so that neither can.
  logic [1:0] answer;
  always_comb begin
    answer = 2'd0;
    for (int n = 0; n < Planes; n++) begin
      if (s_l_i[n] && s_m_i[n]) begin
        case ({r_l_i[n], r_m_i[n]})
          2'b10: answer = (answer == 2'd0) ? 2'd1 : (answer == 2'd2) ? 2'd3 : answer;
          2'b01: answer = (answer == 2'd0) ? 2'd2 : (answer == 2'd1) ? 2'd3 : answer;
          default: answer = answer;
        endcase
      end
    end
  end

  assign ok_o = hides == (answer == 2'd1) && hidden == (answer == 2'd2) &&
                unresolved == (answer == 2'd0) &&
                turned_hides == hidden && turned_hidden == hides &&
                turned_unresolved == unresolved &&
                !self_hides && !self_hidden && self_unresolved;
endmodule
