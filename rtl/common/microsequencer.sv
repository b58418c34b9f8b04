// SPDX-License-Identifier: MIT
// Microsequencer: one microinstruction a clock, in the manner of the Am2910 (Advanced Micro Devices
// 1977: the sixteen instructions, addresses of 12 bits, the register/counter and the stack of five
// are published there). That a machine of 1975 had its like is reconstruction. The instructions, and
// where this differs from the chip, are in docs/machine/microprograms.md, "Sequencer".
`include "rtl/common/assertions.svh"

module microsequencer #(
    parameter int StackDepth = 5,  // 2 or more
    localparam int LevelWidth = $clog2(StackDepth + 1)
) (
    input  logic        clk_i,
    input  logic        rst_i,
    input  logic [ 3:0] op_i,
    input  logic        pass_i,           // the condition, as the processor chose it
    input  logic [11:0] d_i,
    output logic [11:0] micro_address_o,  // of the instruction of this clock
    output logic [11:0] counter_o,
    output logic [11:0] stack_top_o,      // 0 when the stack is empty
    output logic [LevelWidth-1:0] stack_level_o
);
  localparam logic [3:0] Jz = 4'd0, Cjs = 4'd1, Jmap = 4'd2, Cjp = 4'd3;
  localparam logic [3:0] Push = 4'd4, Jsrp = 4'd5, Cjv = 4'd6, Jrp = 4'd7;
  localparam logic [3:0] Rfct = 4'd8, Rpct = 4'd9, Crtn = 4'd10, Cjpp = 4'd11;
  localparam logic [3:0] Ldct = 4'd12, Loop = 4'd13, Twb = 4'd15;

  logic [11:0] micro_address_q, micro_address_d;
  logic [11:0] counter_q, counter_d;
  logic [LevelWidth-1:0] level_q, level_d;
  logic [11:0] stack_q[StackDepth];

  logic [11:0] pc;
  logic counting, push, pop, clear;
  assign pc = micro_address_q + 12'd1;
  assign counting = counter_q != '0;

  // Where the stack's next word goes: above the top, or over it when the stack is full.
  logic [LevelWidth-1:0] push_at;
  assign push_at = level_q == LevelWidth'(StackDepth) ? level_q - 1'b1 : level_q;
  logic [LevelWidth-1:0] top_at;
  assign top_at = level_q == '0 ? level_q : level_q - 1'b1;
  assign stack_top_o = level_q == '0 ? '0 : stack_q[top_at];

  always_comb begin
    micro_address_d = pc;
    counter_d = counter_q;
    push = 1'b0;
    pop = 1'b0;
    clear = 1'b0;
    unique case (op_i)
      Jz: begin
        micro_address_d = '0;
        clear = 1'b1;
      end
      Cjs: begin
        push = pass_i;
        if (pass_i) micro_address_d = d_i;
      end
      Jmap: micro_address_d = d_i;
      Cjp, Cjv: if (pass_i) micro_address_d = d_i;
      Push: begin
        push = 1'b1;
        if (pass_i) counter_d = d_i;
      end
      Jsrp: begin
        push = 1'b1;
        micro_address_d = pass_i ? d_i : counter_q;
      end
      Jrp: micro_address_d = pass_i ? d_i : counter_q;
      Rfct: begin
        pop = !counting;
        if (counting) begin
          counter_d = counter_q - 12'd1;
          micro_address_d = stack_top_o;
        end
      end
      Rpct:
      if (counting) begin
        counter_d = counter_q - 12'd1;
        micro_address_d = d_i;
      end
      Crtn: begin
        pop = pass_i;
        if (pass_i) micro_address_d = stack_top_o;
      end
      Cjpp: begin
        pop = pass_i;
        if (pass_i) micro_address_d = d_i;
      end
      Ldct: counter_d = d_i;
      Loop: begin
        pop = pass_i;
        if (!pass_i) micro_address_d = stack_top_o;
      end
      Twb: begin
        pop = pass_i || !counting;
        if (counting) counter_d = counter_q - 12'd1;
        if (!pass_i) micro_address_d = counting ? stack_top_o : d_i;
      end
      default: ;  // CONT: the next one
    endcase
  end

  always_comb begin
    level_d = level_q;
    if (clear) level_d = '0;
    else if (push) level_d = push_at + 1'b1;
    else if (pop) level_d = top_at;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      micro_address_q <= '0;
      counter_q <= '0;
      level_q <= '0;
    end else begin
      micro_address_q <= micro_address_d;
      counter_q <= counter_d;
      level_q <= level_d;
    end
  end

  always_ff @(posedge clk_i) if (push) stack_q[push_at] <= pc;

  assign micro_address_o = micro_address_q;
  assign counter_o = counter_q;
  assign stack_level_o = level_q;

  `CIGSIM_ASSERT(stack_level_in_range, level_q <= LevelWidth'(StackDepth))
  `CIGSIM_ASSERT(stack_moves_one_way, !(push && pop) && !(clear && (push || pop)))
endmodule
