// SPDX-License-Identifier: MIT
// One step of item_output from any values in its registers, by rules PP5, PP6 and PP8 of
// docs/machine/priority_processor.md: what is put, what is dropped, and what every bit counts.
// registers: valid_q end_q set_q item_q items_q grounds_q ground_item_q
module item_output_proof (
    input logic        clk_i,
    input logic        second_i,
    input logic        rst_i,
    input logic [31:0] capacity_i,
    input logic        clear_i,
    input logic [ 1:0] kind_i,      // of what is put: 0 nothing, 1 an item, 2 ground, 3 the end
    input logic        load_i,
    input logic [31:0] word_i,
    input logic        ready_i,

    input logic        valid_q,
    input logic        end_q,
    input logic [ 1:0] set_q,
    input logic [29:0] item_q,
    input logic [31:0] items_q,
    input logic [31:0] grounds_q,
    input logic [29:0] ground_item_q,
    output logic       ok_o
);
  logic full, drop, grounds, valid, end_word;
  logic [1:0] set;
  logic [29:0] item;
  item_output dut (
      .clk_i(clk_i), .rst_i(rst_i), .cfg_object_capacity_i(capacity_i), .clear_i(clear_i),
      .put_item_i(kind_i == 2'd1), .put_ground_i(kind_i == 2'd2), .put_end_i(kind_i == 2'd3),
      .load_grounds_i(load_i), .word_i(word_i), .full_o(full), .drop_o(drop),
      .grounds_o(grounds), .item_valid_o(valid), .item_set_o(set), .item_o(item),
      .item_end_o(end_word), .item_ready_i(ready_i)
  );

  logic item_comes, dropped, waits, goes_in, outputs_ok;
  always_comb begin
    item_comes = kind_i == 2'd1 || kind_i == 2'd2;
    dropped = 1'b0;
    if (item_comes && capacity_i != 0) dropped = (items_q ^ capacity_i) == 0;
    waits = valid_q && !ready_i && !dropped;
    goes_in = kind_i != 0 && !dropped && !waits;
    outputs_ok = drop == dropped && full == waits && grounds == (|grounds_q) &&
        {valid, set, item, end_word} == {valid_q, set_q, item_q, end_q};
  end

  // The registers after the step.
  logic valid_n, end_n;
  logic [1:0] set_n;
  logic [29:0] item_n, ground_item_n;
  logic [31:0] items_n, grounds_n;
  always_ff @(posedge clk_i) begin
    valid_n <= valid_q && !ready_i;
    end_n <= end_q;
    set_n <= set_q;
    item_n <= item_q;
    items_n <= items_q;
    grounds_n <= grounds_q;
    ground_item_n <= ground_item_q;
    if (goes_in) begin
      valid_n <= 1'b1;
      case (kind_i)
        2'd1: {set_n, item_n, end_n} <= {1'b0, word_i[30:0], 1'b0};
        2'd2: {set_n, item_n, end_n} <= {2'd2, ground_item_q, 1'b0};
        default: {set_n, item_n, end_n} <= 33'd1;
      endcase
    end
    if (rst_i) valid_n <= 1'b0;
    if (goes_in && item_comes) items_n <= items_q - 32'hffff_ffff;
    if (kind_i == 2'd2 && !waits) begin
      ground_item_n <= ground_item_q - 30'h3fff_ffff;
      grounds_n <= grounds_q + 32'hffff_ffff;
    end
    if (load_i) grounds_n <= word_i;
    if (clear_i) begin
      items_n <= 32'd0;
      ground_item_n <= 30'd0;
    end
  end

  assign ok_o = second_i
      ? {valid_n, end_n, set_n, item_n, items_n, grounds_n, ground_item_n} ==
        {valid_q, end_q, set_q, item_q, items_q, grounds_q, ground_item_q}
      : outputs_ok;
endmodule
