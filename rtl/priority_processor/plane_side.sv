// SPDX-License-Identifier: MIT
// Side of the eyepoint: N.R - d summed term by term in an accumulator of 64 bits, N a unit normal in
// 1.30 and R the eyepoint in scaled coordinates (Stump 1986, ch. II and III: the eye is on the TRUE
// side of a separation plane when the sum is not negative). The data path, one product of 32 by 32
// bits a clock, and all word lengths are reconstruction (docs/machine/priority_processor.md).
`include "rtl/common/assertions.svh"

module plane_side (
    input  logic        clk_i,
    input  logic        rst_i,
    input  logic [ 2:0] load_eye_i,    // x, y, z: the word becomes this coordinate of the eyepoint
    input  logic [ 2:0] product_i,     // x, y, z: times the word; x begins the sum, y and z add
    input  logic        take_low_i,    // less the low half of d
    input  logic        take_high_i,   // less the high half
    input  logic [31:0] word_i,
    output logic        eye_true_o,
    output logic [63:0] accumulator_o
);
  logic signed [31:0] eye_x_q, eye_y_q, eye_z_q;
  always_ff @(posedge clk_i) begin
    if (load_eye_i[0]) eye_x_q <= word_i;
    if (load_eye_i[1]) eye_y_q <= word_i;
    if (load_eye_i[2]) eye_z_q <= word_i;
  end

  logic signed [31:0] eye;
  assign eye = product_i[0] ? eye_x_q : product_i[1] ? eye_y_q : eye_z_q;
  logic signed [63:0] product;
  assign product = 64'(eye) * 64'($signed(word_i));

  logic [63:0] accumulator_q, accumulator_d;
  always_comb begin
    accumulator_d = accumulator_q;
    if (product_i[0]) accumulator_d = product;
    else if (product_i != '0) accumulator_d = accumulator_q + product;
    else if (take_low_i) accumulator_d = accumulator_q - {32'b0, word_i};
    else if (take_high_i) accumulator_d = accumulator_q - {word_i, 32'b0};
  end
  always_ff @(posedge clk_i) accumulator_q <= accumulator_d;

  assign accumulator_o = accumulator_q;
  assign eye_true_o = !accumulator_q[63];

  // |N.R| is below 2^61 and |d| at most 2^62, so a sum never leaves 64 bits.
  `CIGSIM_ASSERT(products_stay_in_range,
                 !(|product_i[2:1]) || (accumulator_d[63] == accumulator_d[62]))
  `CIGSIM_ASSERT(one_term_a_clock, $onehot0({product_i, take_low_i, take_high_i}))
endmodule
