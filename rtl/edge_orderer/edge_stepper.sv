// SPDX-License-Identifier: MIT
// An edge from one raster line to the next, by adding its slope (Sandor 1979, sec. 5.2), and the
// element that it crosses. Rules EO1 and EO2 of docs/machine/edge_orderer.md; words and saturation
// are reconstruction.
module edge_stepper (
    input  logic [13:0] width_i,  // of the raster
    input  logic [31:0] x_i,          // 13.18
    input  logic [31:0] slope_i,      // 13.18
    output logic [13:0] element_o,    // the smallest whole number not below x, in 0..width
    output logic [31:0] x_o,          // on the next line
    output logic        saturated_o   // it did not fit, and is the nearest that does
);
  localparam int Fraction = 18;

  logic [13:0] whole;
  assign whole = {1'b0, x_i[30:Fraction]} + 14'(|x_i[Fraction-1:0]);

  assign element_o = x_i[31] ? '0 : whole > width_i ? width_i : whole;

  logic [31:0] sum;
  assign sum = x_i + slope_i;
  assign saturated_o = x_i[31] == slope_i[31] && sum[31] != x_i[31];
  assign x_o = saturated_o ? {slope_i[31], {31{!slope_i[31]}}} : sum;
endmodule
