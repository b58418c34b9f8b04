// SPDX-License-Identifier: MIT
// One step of microsequencer from any values in its registers: the table of docs/machine/
// microprograms.md, "Sequencer", row by row.
// registers: micro_address_q counter_q level_q stack_q[StackDepthx12]
module microsequencer_proof #(
    parameter int StackDepth = 5  // up to 6
) (
    input logic        clk_i,
    input logic        second_i,
    input logic        rst_i,
    input logic [ 3:0] op_i,
    input logic        pass_i,
    input logic [11:0] d_i,

    input logic [             11:0] micro_address_q,
    input logic [             11:0] counter_q,
    input logic [              2:0] level_q,
    input logic [StackDepth*12-1:0] stack_q,
    output logic                    ok_o
);
  logic [11:0] address, counter, top;
  logic [2:0] level;
  microsequencer #(.StackDepth(StackDepth)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .op_i(op_i), .pass_i(pass_i), .d_i(d_i),
      .micro_address_o(address), .counter_o(counter), .stack_top_o(top), .stack_level_o(level)
  );

  logic [11:0] f, pc, r;
  always_comb begin
    pc = micro_address_q + 12'd1;
    r = counter_q;
    f = 12'd0;
    for (int n = 0; n < StackDepth; n++) if (level_q == n + 1) f = stack_q[n*12+:12];
  end

  // To where, what the stack does (0 nothing, 1 push PC, 2 pop, 3 empty), and R.
  logic [11:0] to, r_d;
  logic [1:0] stack;
  always_comb begin
    r_d = r;
    case ({op_i, pass_i})
      {4'd0, 1'b0}, {4'd0, 1'b1}: {to, stack} = {12'd0, 2'd3};
      {4'd1, 1'b0}: {to, stack} = {pc, 2'd0};
      {4'd1, 1'b1}: {to, stack} = {d_i, 2'd1};
      {4'd2, 1'b0}, {4'd2, 1'b1}: {to, stack} = {d_i, 2'd0};
      {4'd3, 1'b0}: {to, stack} = {pc, 2'd0};
      {4'd3, 1'b1}: {to, stack} = {d_i, 2'd0};
      {4'd4, 1'b0}: {to, stack} = {pc, 2'd1};
      {4'd4, 1'b1}: {to, stack, r_d} = {pc, 2'd1, d_i};
      {4'd5, 1'b0}: {to, stack} = {r, 2'd1};
      {4'd5, 1'b1}: {to, stack} = {d_i, 2'd1};
      {4'd6, 1'b0}: {to, stack} = {pc, 2'd0};
      {4'd6, 1'b1}: {to, stack} = {d_i, 2'd0};
      {4'd7, 1'b0}: {to, stack} = {r, 2'd0};
      {4'd7, 1'b1}: {to, stack} = {d_i, 2'd0};
      {4'd8, 1'b0}, {4'd8, 1'b1}: {to, stack, r_d} = r != 0 ? {f, 2'd0, r - 12'd1} : {pc, 2'd2, r};
      {4'd9, 1'b0}, {4'd9, 1'b1}:
      {to, stack, r_d} = r != 0 ? {d_i, 2'd0, r - 12'd1} : {pc, 2'd0, r};
      {4'd10, 1'b0}: {to, stack} = {pc, 2'd0};
      {4'd10, 1'b1}: {to, stack} = {f, 2'd2};
      {4'd11, 1'b0}: {to, stack} = {pc, 2'd0};
      {4'd11, 1'b1}: {to, stack} = {d_i, 2'd2};
      {4'd12, 1'b0}, {4'd12, 1'b1}: {to, stack, r_d} = {pc, 2'd0, d_i};
      {4'd13, 1'b0}: {to, stack} = {f, 2'd0};
      {4'd13, 1'b1}: {to, stack} = {pc, 2'd2};
      {4'd15, 1'b0}: {to, stack, r_d} = r != 0 ? {f, 2'd0, r - 12'd1} : {d_i, 2'd2, r};
      {4'd15, 1'b1}: {to, stack, r_d} = r != 0 ? {pc, 2'd2, r - 12'd1} : {pc, 2'd2, r};
      default: {to, stack} = {pc, 2'd0};
    endcase
  end

  logic in_range, in_range_q;
  logic [2:0] level_n;
  logic [11:0] address_n, counter_n;
  logic [StackDepth*12-1:0] stack_n;
  assign in_range = level_q <= StackDepth;
  always_ff @(posedge clk_i) begin
    in_range_q <= in_range;
    {address_n, counter_n, level_n, stack_n} <= {to, r_d, level_q, stack_q};
    if (stack == 2'd1) begin
      if (level_q < StackDepth) level_n <= level_q + 3'd1;
      for (int n = 0; n < StackDepth; n++)
        if (level_q == n || (level_q == StackDepth && n == StackDepth - 1))
          stack_n[n*12+:12] <= pc;
    end
    if (stack == 2'd2 && level_q != 0) level_n <= level_q - 3'd1;
    if (stack == 2'd3) level_n <= 3'd0;
    if (rst_i) {address_n, counter_n, level_n} <= 27'd0;
  end
  assign ok_o = second_i
      ? !in_range_q || {address_n, counter_n, level_n, stack_n} ==
                       {micro_address_q, counter_q, level_q, stack_q}
      : !in_range || (address == micro_address_q && counter == r && top == f && level == level_q);
endmodule
