// SPDX-License-Identifier: MIT
// One step of group_places from any values in its registers: order and place memory, and level, of
// docs/machine/priority_processor.md. Members and levels are powers of two. Outside of all groups is
// the level before the first.
// registers: level_q places_q[Levelsx2*ListedWidth] order_q[Levels*Membersx32]
module group_places_proof #(
    parameter int Members = 8,
    parameter int Levels = 4,
    parameter int ListedWidth = 4,  // of numbers up to Members
    localparam int MemberWidth = $clog2(Members),
    localparam int LevelWidth = $clog2(Levels + 1),
    localparam int PlaceBits = 2 * ListedWidth
) (
    input logic                   clk_i,
    input logic                   second_i,
    input logic                   rst_i,
    input logic [            1:0] level_i,  // 1: out of all groups, 2: into one, 3: out of it
    input logic                   write_i,
    input logic [MemberWidth-1:0] at_i,
    input logic [           31:0] entry_i,
    input logic [            1:0] place_i,  // 1: place 0, 2: the next one
    input logic [ListedWidth-1:0] number_i,

    input logic [       LevelWidth-1:0] level_q,
    input logic [ Levels*PlaceBits-1:0] places_q,  // of each level: number, place
    input logic [Levels*Members*32-1:0] order_q,   // of each level: the members' entries
    output logic                        ok_o
);
  logic [31:0] entry;
  logic opened, inside_group;
  group_places #(.Members(Members), .Levels(Levels)) dut (
      .clk_i(clk_i), .rst_i(rst_i), .level_outside_i(level_i == 2'd1),
      .level_inc_i(level_i == 2'd2), .level_dec_i(level_i == 2'd3), .entry_write_i(write_i),
      .entry_place_i(at_i), .entry_i(entry_i), .place_begin_i(place_i == 2'd1),
      .place_next_i(place_i == 2'd2), .number_i(number_i), .entry_o(entry), .opened_o(opened),
      .inside_o(inside_group)
  );
  localparam logic [LevelWidth-1:0] Outside = {LevelWidth{1'b1}};

  // Level by level; outside is as the last one, where nothing is asked.
  logic [31:0] next_entry;
  logic [Levels*PlaceBits-1:0] places_d;
  logic [Levels*Members*32-1:0] order_d;
  logic [LevelWidth-1:0] level_d;
  logic all_opened;
  always_comb begin
    next_entry = 32'd0;
    all_opened = 1'b0;
    places_d = places_q;
    order_d = order_q;
    for (int l = 0; l < Levels; l++)
      if (level_q[LevelWidth-2:0] == l) begin
        all_opened = places_q[l*PlaceBits+:ListedWidth] ==
            places_q[l*PlaceBits+ListedWidth+:ListedWidth];
        for (int n = 0; n < Members; n++) begin
          if (places_q[l*PlaceBits+:MemberWidth] == n)
            next_entry = order_q[(l*Members+n)*32+:32];
          if (write_i && at_i == n) order_d[(l*Members+n)*32+:32] = entry_i;
        end
        if (place_i == 2'd1) places_d[l*PlaceBits+:PlaceBits] = {number_i, {ListedWidth{1'b0}}};
        if (place_i == 2'd2)
          places_d[l*PlaceBits+:ListedWidth] = places_q[l*PlaceBits+:ListedWidth] + 1'b1;
      end
    case (level_i)
      2'd1: level_d = Outside;
      2'd2: level_d = level_q + 1'b1;
      2'd3: level_d = level_q + Outside;
      default: level_d = level_q;
    endcase
    if (rst_i) level_d = Outside;
  end

  logic [LevelWidth+Levels*PlaceBits+Levels*Members*32-1:0] after;
  always_ff @(posedge clk_i) after <= {level_d, places_d, order_d};
  assign ok_o = second_i ? after == {level_q, places_q, order_q}
                         : entry == next_entry && opened == all_opened &&
                           inside_group == (level_q != Outside);
endmodule
