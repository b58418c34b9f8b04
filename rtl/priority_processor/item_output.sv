// SPDX-License-Identifier: MIT
// Output register for items, with the limit on their number. A word waits for the register to be
// free: it holds none, or its word is taken in this clock (rule PP8 of docs/machine/
// priority_processor.md); an item beyond the capacity is dropped and waits for nothing (PP6).
// Ground items are numbered here; they come last ("objects always have priority over the ground",
// Stump 1986). Reconstruction but for that.
`include "rtl/common/assertions.svh"

module item_output (
    input logic clk_i,
    input logic rst_i,

    input logic [31:0] cfg_object_capacity_i,  // 0: no limit

    input  logic        clear_i,         // a frame begins
    input  logic        put_item_i,      // the word, an item
    input  logic        put_ground_i,    // the next ground item
    input  logic        put_end_i,
    input  logic        load_grounds_i,  // the word: how many ground items there are
    input  logic [31:0] word_i,
    output logic        full_o,          // what is to be put must wait
    output logic        drop_o,          // an item is dropped
    output logic        grounds_o,       // ground items are left

    output logic        item_valid_o,
    output logic [ 1:0] item_set_o,    // 0 static, 1 moving, 2 ground
    output logic [29:0] item_o,
    output logic        item_end_o,
    input  logic        item_ready_i
);
  localparam logic [1:0] Static = 2'd0, Moving = 2'd1, Ground = 2'd2;

  logic valid_q, end_q;
  logic [1:0] set_q;
  logic [29:0] item_q;
  logic [31:0] items_q, grounds_q;
  logic [29:0] ground_item_q;

  logic free, put_counted, put;
  assign free = !valid_q || item_ready_i;
  assign put_counted = put_item_i || put_ground_i;
  assign drop_o = put_counted && cfg_object_capacity_i != '0 && items_q == cfg_object_capacity_i;
  assign full_o = !free && !drop_o;
  assign put = (put_counted || put_end_i) && free && !drop_o;

  always_ff @(posedge clk_i) begin
    if (rst_i) valid_q <= 1'b0;
    else if (free) valid_q <= put;

    if (put) begin
      end_q <= put_end_i;
      set_q <= put_end_i ? Static : put_ground_i ? Ground : word_i[30] ? Moving : Static;
      item_q <= put_end_i ? '0 : put_ground_i ? ground_item_q : word_i[29:0];
    end
  end

  always_ff @(posedge clk_i) begin
    if (clear_i) items_q <= '0;
    else if (put && put_counted) items_q <= items_q + 32'd1;

    if (clear_i) ground_item_q <= '0;
    else if (put_ground_i && !full_o) ground_item_q <= ground_item_q + 30'd1;

    if (load_grounds_i) grounds_q <= word_i;
    else if (put_ground_i && !full_o) grounds_q <= grounds_q - 32'd1;
  end
  assign grounds_o = grounds_q != '0;

  assign item_valid_o = valid_q;
  assign item_set_o = set_q;
  assign item_o = item_q;
  assign item_end_o = end_q;

`ifdef CIGSIM_ASSERTIONS
  logic [32:0] offered_q;
  logic waited_q;
  logic [31:0] capacity_q;
  always_ff @(posedge clk_i) begin
    offered_q <= {set_q, item_q, end_q};
    waited_q <= !rst_i && valid_q && !item_ready_i;
    capacity_q <= cfg_object_capacity_i;
  end
`endif
  `CIGSIM_ASSERT(offer_is_held, !waited_q ||
                 (valid_q && offered_q == {set_q, item_q, end_q}))
  `CIGSIM_ASSERT(end_is_blank, !(valid_q && end_q) || (set_q == '0 && item_q == '0))
  `CIGSIM_ASSERT(capacity_is_steady, cfg_object_capacity_i == capacity_q)
  `CIGSIM_ASSERT(within_capacity, cfg_object_capacity_i == '0 || !put_counted ||
                 items_q <= cfg_object_capacity_i)
  `CIGSIM_ASSERT(one_put_a_clock, $onehot0({put_item_i, put_ground_i, put_end_i}))
  `CIGSIM_ASSERT(ground_item_exists, !put_ground_i || grounds_o)
endmodule
