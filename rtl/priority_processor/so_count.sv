// SPDX-License-Identifier: MIT
// A plane crossing, for one pair of the separating-object matrix. Instead of the words RR_l and
// RR_m of Levine 1975, ch. VI.E, a pair keeps how many bits they have: the planes that part the two
// and have l, or m, on the near side. The answer needs only whether each is zero. When the eye
// crosses a plane that parts the two, it goes from one count to the other; where the plane does not
// tell of both, or has both on one side, nothing changes. Counts instead of words are a
// reconstruction.
module so_count #(
    parameter int Planes = 64,
    localparam int CountWidth = $clog2(Planes + 1)
) (
    input  logic                  known_i,      // the plane was counted, with the eye beyond it
    input  logic                  tells_l_i,
    input  logic                  near_l_i,     // on the eye's side as it is now
    input  logic                  tells_m_i,
    input  logic                  near_m_i,
    input  logic [CountWidth-1:0] nearer_l_i,
    input  logic [CountWidth-1:0] nearer_m_i,
    output logic [CountWidth-1:0] nearer_l_o,
    output logic [CountWidth-1:0] nearer_m_o
);
  logic l_gains, m_gains, l_loses, m_loses;
  assign l_gains = tells_l_i & tells_m_i & near_l_i & ~near_m_i;
  assign m_gains = tells_l_i & tells_m_i & near_m_i & ~near_l_i;
  assign l_loses = m_gains & known_i;
  assign m_loses = l_gains & known_i;

  assign nearer_l_o = nearer_l_i + CountWidth'(l_gains) - CountWidth'(l_loses);
  assign nearer_m_o = nearer_m_i + CountWidth'(m_gains) - CountWidth'(m_loses);
endmodule
