// SPDX-License-Identifier: MIT
// The whole separating-object matrix at once (Levine 1975, ch. VI.E), without memory or clock: for
// counts of gates, for proofs, and for machines of few objects. Row l of an answer has bits
// l * Objects and up. The matrix is anti-symmetric, and its diagonal is zero.
module so_matrix #(
    parameter int Objects = 5,
    parameter int Planes  = 4
) (
    input  logic [ Objects*Planes-1:0] s_i,
    input  logic [ Objects*Planes-1:0] r_i,
    output logic [Objects*Objects-1:0] hides_o,
    output logic [Objects*Objects-1:0] hidden_o,
    output logic [Objects*Objects-1:0] unresolved_o
);
  for (genvar l = 0; l < Objects; l++) begin : g_row
    localparam logic [Objects-1:0] Self = {{(Objects - 1) {1'b0}}, 1'b1} << l;
    so_row #(
        .Objects(Objects),
        .Planes (Planes)
    ) u_row (
        .s_l_i       (s_i[l*Planes+:Planes]),
        .r_l_i       (r_i[l*Planes+:Planes]),
        .s_i         (s_i),
        .r_i         (r_i),
        .asked_i     (~Self),
        .hides_o     (hides_o[l*Objects+:Objects]),
        .hidden_o    (hidden_o[l*Objects+:Objects]),
        .unresolved_o(unresolved_o[l*Objects+:Objects])
    );
  end
endmodule
