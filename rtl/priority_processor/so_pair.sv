// SPDX-License-Identifier: MIT
// One pair of the separating-object matrix: SO(l, m) from two marked rows of SEPL (Levine 1975, ch.
// VI.E). A row is two words with a bit a plane: S, the plane tells of the object (it lies on one
// side of it); R, the object is on the eye's side. R counts only where S is set.
// Three wires carry four answers, and at most one of them is set:
//   hides_o       SO = +1: l may hide m
//   hidden_o      SO = -1: m may hide l (the source prints 1 here; its own example has -1)
//   none          SO =  0: planes stand on both sides, neither can hide the other
//   unresolved_o  no plane parts the two. The source reads this as 0; as an answer of its own it is
//                 a reconstruction.
module so_pair #(
    parameter int Planes = 64
) (
    input  logic [Planes-1:0] s_l_i,
    input  logic [Planes-1:0] r_l_i,
    input  logic [Planes-1:0] s_m_i,
    input  logic [Planes-1:0] r_m_i,
    output logic              hides_o,
    output logic              hidden_o,
    output logic              unresolved_o
);
  logic [Planes-1:0] both, differ;
  logic l_nearer, m_nearer;

  assign both = s_l_i & s_m_i;
  assign differ = (r_l_i ^ r_m_i) & both;
  assign l_nearer = |(r_l_i & differ);
  assign m_nearer = |(r_m_i & differ);

  assign hides_o = l_nearer & ~m_nearer;
  assign hidden_o = m_nearer & ~l_nearer;
  assign unresolved_o = ~(l_nearer | m_nearer);
endmodule
