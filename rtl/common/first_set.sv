// SPDX-License-Identifier: MIT
// The first bit that is set, as a 74148 and its gates would tell it; cascaded by the width.
// Reconstruction: the sources say that the member, or face, of highest priority is found, not how.
// Neighbouring groups of 1, 2, 4, ... bits are joined, so that the delay grows with the logarithm of
// the width. Quick in simulation up to 64 bits, of one word; wider ones are better cascaded.
module first_set #(
    parameter int Width = 64,  // 2 or more
    localparam int IndexWidth = $clog2(Width)
) (
    input  logic [     Width-1:0] bits_i,
    output logic                  any_o,
    output logic [IndexWidth-1:0] index_o  // 0 where no bit is set
);
  // What is told of a group stands at the group's first bit; other bits of these words mean nothing.
  logic [Width-1:0] any, next;         // a bit is set in the group, and in the one after it
  logic [IndexWidth*Width-1:0] index;  // a word for each bit of the index within the group

  always_comb begin
    any = bits_i;
    next = '0;
    index = '0;
    for (int level = 0; level < IndexWidth; level++) begin
      next = any >> (1 << level);
      for (int k = 0; k < IndexWidth; k++) begin
        if (k < level) begin
          index[k*Width+:Width] = (any & index[k*Width+:Width]) |
                                  (~any & (index[k*Width+:Width] >> (1 << level)));
        end
      end
      index[level*Width+:Width] = ~any & next;
      any = any | next;
    end
  end

  for (genvar k = 0; k < IndexWidth; k++) begin : g_index
    assign index_o[k] = index[k*Width];
  end
  assign any_o = any[0];
endmodule
