// SPDX-License-Identifier: MIT
// edge_stepper by rules EO1 and EO2 of docs/machine/edge_orderer.md, in words that are wide enough
// for whatever comes out.
module edge_stepper_proof (
    input  logic [13:0] width_i,
    input  logic [31:0] x_i,
    input  logic [31:0] slope_i,
    output logic        ok_o
);
  logic [13:0] element;
  logic [31:0] next;
  logic saturated;
  edge_stepper dut (
      .width_i(width_i), .x_i(x_i), .slope_i(slope_i),
      .element_o(element), .x_o(next), .saturated_o(saturated)
  );

  localparam logic signed [39:0] Highest = 40'sd2147483647, Lowest = -40'sd2147483648;
  logic signed [39:0] x, right, at, sum;
  logic element_ok, next_ok;
  always_comb begin
    x = $signed(x_i);
    right = $signed({1'b0, width_i, 18'd0});
    at = $signed({1'b0, element, 18'd0});
    // The smallest whole number not below x, or the end of the raster that is nearest.
    if (x <= 0) element_ok = element == 0;
    else if (x > right) element_ok = element == width_i;
    else element_ok = at >= x && at - 40'sd262144 < x;

    sum = x + $signed(slope_i);
    if (sum > Highest) next_ok = saturated && $signed(next) == Highest;
    else if (sum < Lowest) next_ok = saturated && $signed(next) == Lowest;
    else next_ok = !saturated && $signed(next) == sum;
  end
  assign ok_o = element_ok && next_ok;
endmodule
