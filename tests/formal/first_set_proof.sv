// SPDX-License-Identifier: MIT
// first_set tells a bit that is set, with none before it; and whether there is one.
module first_set_proof #(
    parameter int Width = 64,
    localparam int IndexWidth = $clog2(Width)
) (
    input  logic [Width-1:0] bits_i,
    output logic             ok_o
);
  logic any;
  logic [IndexWidth-1:0] index;
  first_set #(.Width(Width)) u_first (.bits_i(bits_i), .any_o(any), .index_o(index));

  // What is kept of the word when its first bit is taken for itself: two's complement.
  logic [Width-1:0] first;
  assign first = bits_i & (~bits_i + {{(Width - 1) {1'b0}}, 1'b1});
  assign ok_o = any ? first == {{(Width - 1) {1'b0}}, 1'b1} << index && bits_i != '0
                    : bits_i == '0 && index == '0;
endmodule
