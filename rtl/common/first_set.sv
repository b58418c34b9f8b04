// SPDX-License-Identifier: MIT
// The first bit that is set, as a 74148 and its gates would tell it; cascaded by the width.
// Reconstruction: the sources say that the member, or face, of highest priority is found, not how.
module first_set #(
    parameter int Width = 64,  // 2 or more
    localparam int IndexWidth = $clog2(Width)
) (
    input  logic [     Width-1:0] bits_i,
    output logic                  any_o,
    output logic [IndexWidth-1:0] index_o  // 0 where no bit is set
);
  always_comb begin
    index_o = '0;
    for (int i = Width - 1; i >= 0; i--) if (bits_i[i]) index_o = i[IndexWidth-1:0];
  end
  assign any_o = |bits_i;
endmodule
