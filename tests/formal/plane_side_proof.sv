// SPDX-License-Identifier: MIT
// One step of plane_side from any values in its registers (rule PP1 of docs/machine/
// priority_processor.md), in all 64 bits of the sum. A product is proved for coordinates that have
// one bit set at most, or all from one bit on (so of both signs), and any word: a product of any two
// words is beyond the solver. The tests have random ones.
// registers: eye_x_q eye_y_q eye_z_q accumulator_q
module plane_side_proof (
    input logic        clk_i,
    input logic        second_i,
    input logic [ 2:0] load_i,
    input logic [ 2:0] work_i,  // 1, 2, 3: times x, y, z; 4, 5: less d, low and high
    input logic [31:0] word_i,
    input logic [ 4:0] bit_i,
    input logic [ 1:0] coordinate_i,  // 0: zero; 1: the bit alone; 2: all bits from it on

    input logic [31:0] eye_x_q,
    input logic [31:0] eye_y_q,
    input logic [31:0] eye_z_q,
    input logic [63:0] accumulator_q,
    output logic       ok_o
);
  logic eye_true;
  logic [63:0] accumulator;
  plane_side dut (
      .clk_i(clk_i), .rst_i(1'b0), .load_eye_i(load_i),
      .product_i({work_i == 3'd3, work_i == 3'd2, work_i == 3'd1}), .take_low_i(work_i == 3'd4),
      .take_high_i(work_i == 3'd5), .word_i(word_i), .eye_true_o(eye_true),
      .accumulator_o(accumulator)
  );

  // -(2^n) is all bits from n on; as a number of 32 bits the bit 31 alone is -(2^31) as well.
  logic [31:0] coordinate, power;
  logic minus, assumed;
  logic [63:0] word, shifted, product;
  always_comb begin
    power = 32'd1 << bit_i;
    case (work_i)
      3'd1: coordinate = eye_x_q;
      3'd2: coordinate = eye_y_q;
      default: coordinate = eye_z_q;
    endcase
    case (coordinate_i)
      2'd1: assumed = coordinate == power;
      2'd2: assumed = coordinate == ~power + 32'd1;
      default: assumed = coordinate == 0;
    endcase
    if (work_i == 0 || work_i > 3) assumed = 1'b1;
    minus = coordinate_i == 2'd2 || bit_i == 5'd31;
    word = {{32{word_i[31]}}, word_i};
    shifted = word << bit_i;
    product = coordinate == 0 ? 64'd0 : minus ? ~shifted + 64'd1 : shifted;
  end

  logic assumed_q;
  logic [63:0] accumulator_n;
  logic [95:0] eye_n;
  always_ff @(posedge clk_i) begin
    assumed_q <= assumed;
    eye_n <= {load_i[0] ? word_i : eye_x_q, load_i[1] ? word_i : eye_y_q,
              load_i[2] ? word_i : eye_z_q};
    case (work_i)
      3'd1: accumulator_n <= product;
      3'd2, 3'd3: accumulator_n <= accumulator_q + product;
      3'd4: accumulator_n <= accumulator_q - {32'd0, word_i};
      3'd5: accumulator_n <= {accumulator_q[63:32] - word_i, accumulator_q[31:0]};
      default: accumulator_n <= accumulator_q;
    endcase
  end
  assign ok_o = second_i
      ? {eye_x_q, eye_y_q, eye_z_q} == eye_n && (!assumed_q || accumulator_q == accumulator_n)
      : eye_true == !accumulator_q[63] && accumulator == accumulator_q;
endmodule
