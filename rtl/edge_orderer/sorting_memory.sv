// SPDX-License-Identifier: MIT
// The sort of a line's crossings along the line (Sandor 1979, sec. 5.3): cells that hold them in
// their order. Rules EO3 and EO4 of docs/machine/edge_orderer.md. Reconstruction: each cell compares
// the crossing that is inserted with its own, and takes the new one or that of a neighbour, so that
// an insertion takes one cycle. While it drains nothing moves: the first full cell is shown.
//
// A cell that is cleared stays in the order, empty, until an insertion uses it up: the cells between
// the new crossing's place and the first empty cell move by one towards that. A cell that was not
// used since the memory drained holds ones, which come after every crossing.
//
// The cells are kept in rows of 16, one word a row, and only those rows are worked out through which
// the insertion goes; this changes nothing but the speed of the simulation.
`include "rtl/common/assertions.svh"

module sorting_memory #(
    parameter int Crossings = 256,  // a power of two, 2 or more
    parameter int PlaceWidth = 12,
    localparam int KeyWidth = 14 + 1 + 24 + PlaceWidth,
    localparam int CountWidth = $clog2(Crossings + 1)
) (
    input logic clk_i,
    input logic rst_i,

    // A crossing is inserted: its element, left, face, and place in the edge memory.
    input logic                insert_i,
    input logic [KeyWidth-1:0] key_i,
    // Room is made for it: the last of the full cells, none of which was cleared, is given up.
    input logic                replace_i,
    // The cells of faces from limit_i on are cleared, whether something is inserted or not.
    input logic                clear_i,
    input logic [        23:0] limit_i,

    output logic [CountWidth-1:0] count_o,    // full cells
    output logic [  KeyWidth-1:0] last_o,     // the last full cell, where none was cleared
    // Where search_i is high: the highest face of the full cells.
    input  logic                  search_i,
    output logic [          23:0] highest_o,
    // Where clear_i is high: how many cells it clears.
    output logic [CountWidth-1:0] cleared_o,

    output logic [KeyWidth-1:0] first_o,  // the first full cell
    input  logic                shift_i,  // it was taken
    input  logic                empty_i   // all was taken; with or without shift_i
);
  localparam int FaceLow = PlaceWidth;
  localparam int RowCells = Crossings < 16 ? Crossings : 16;
  localparam int Rows = Crossings / RowCells;
  localparam int RowWidth = RowCells * KeyWidth;
  localparam int PositionWidth = $clog2(Crossings);
  localparam int CellBits = $clog2(RowCells);  // of a position: which cell of its row
  localparam int RowsPadded = Rows < 2 ? 2 : Rows;
  localparam int FirstRowWidth = $clog2(RowsPadded);

  logic [RowWidth-1:0] rows_q[Rows];
  logic [Crossings-1:0] full_q, stays;
  logic [CountWidth-1:0] count_q, count_d;

  // The last full cell, where all are at the front.
  logic [PositionWidth-1:0] last;
  logic [RowWidth-1:0] last_row, shown_row;
  logic [FirstRowWidth-1:0] first_row;
  assign last = PositionWidth'(count_q - 1'b1);
  if (Rows == 1) begin : gen_one_row
    assign last_row = rows_q[0];
    assign shown_row = rows_q[0];
  end else begin : gen_rows
    assign last_row = rows_q[last[PositionWidth-1:CellBits]];
    assign shown_row = rows_q[first_row];
  end
  assign last_o = last_row[last[CellBits-1:0]*KeyWidth+:KeyWidth];

  // The highest face, and which cells stay full but for the new one. 
  logic [RowWidth-1:0] searched_row, cleared_row;
  always_comb begin
    highest_o = '0;
    searched_row = '0;
    if (search_i) begin
      for (int r = 0; r < Rows; r++) begin
        searched_row = rows_q[r];
        for (int c = 0; c < RowCells; c++) begin
          if (full_q[r*RowCells+c] && searched_row[c*KeyWidth+FaceLow+:24] > highest_o) begin
            highest_o = searched_row[c*KeyWidth+FaceLow+:24];
          end
        end
      end
    end
  end
  always_comb begin
    stays = full_q;
    cleared_o = '0;
    cleared_row = '0;
    if (clear_i) begin
      for (int r = 0; r < Rows; r++) begin
        cleared_row = rows_q[r];
        for (int c = 0; c < RowCells; c++) begin
          if (full_q[r*RowCells+c] && cleared_row[c*KeyWidth+FaceLow+:24] >= limit_i) begin
            stays[r*RowCells+c] = 1'b0;
            cleared_o = cleared_o + 1'b1;
          end
        end
      end
    end
    if (replace_i) stays[last] = 1'b0;
  end

  // Rows with room, and rows with room in a row before them.
  logic [Rows-1:0] room, room_before;
  for (genvar r = 0; r < Rows; r++) begin : gen_room
    assign room[r] = !(&stays[r*RowCells+:RowCells]);
  end
  assign room_before = (room | (~room + 1'b1)) << 1;

  // EO3: a row after the insertion. Between the first cell with a later crossing and the first cell
  // with room each cell takes that of its neighbour, or the new one: upwards where the room comes
  // after the place, downwards where it comes before.
  function automatic logic [RowWidth-1:0] with_key(
      input logic [RowWidth-1:0] row, input logic [KeyWidth-1:0] key,
      input logic [KeyWidth-1:0] lower_neighbour, input logic lower_later,
      input logic [KeyWidth-1:0] upper_neighbour, input logic upper_later,
      input logic [RowCells-1:0] empty, input logic empty_before);
    logic [RowCells-1:0] later, later_below, later_above, reached, reached_below;
    logic [RowWidth-1:0] below, above;
    for (int c = 0; c < RowCells; c++) later[c] = key < row[c*KeyWidth+:KeyWidth];
    reached = empty_before ? '1 : empty | (~empty + 1'b1);
    later_below = {later[RowCells-2:0], lower_later};
    later_above = {upper_later, later[RowCells-1:1]};
    reached_below = {reached[RowCells-2:0], empty_before};
    below = {row[RowWidth-KeyWidth-1:0], lower_neighbour};
    above = {upper_neighbour, row[RowWidth-1:KeyWidth]};
    with_key = row;
    for (int c = 0; c < RowCells; c++) begin
      if (later[c] && !reached_below[c]) begin
        with_key[c*KeyWidth+:KeyWidth] = later_below[c] ? below[c*KeyWidth+:KeyWidth] : key;
      end else if (reached[c] && !later[c]) begin
        with_key[c*KeyWidth+:KeyWidth] = later_above[c] ? key : above[c*KeyWidth+:KeyWidth];
      end
    end
  endfunction

  for (genvar r = 0; r < Rows; r++) begin : gen_row
    logic [KeyWidth-1:0] first_key, last_key, lower, upper;
    logic lower_later, upper_later;
    assign first_key = rows_q[r][0+:KeyWidth];
    assign last_key = rows_q[r][RowWidth-1-:KeyWidth];
    if (r == 0) begin : gen_lowest
      assign lower = '0;
      assign lower_later = 1'b0;
    end else begin : gen_lower
      assign lower = rows_q[r-1][RowWidth-1-:KeyWidth];
      assign lower_later = key_i < lower;
    end
    if (r == Rows - 1) begin : gen_uppermost
      assign upper = '1;
      assign upper_later = 1'b1;
    end else begin : gen_upper
      assign upper = rows_q[r+1][0+:KeyWidth];
      assign upper_later = key_i < upper;
    end
    always_ff @(posedge clk_i) begin
      if (rst_i || empty_i) begin
        rows_q[r] <= '1;
      end else if (insert_i) begin
        if ((key_i < last_key && !room_before[r]) ||
            ((room[r] || room_before[r]) && !(key_i < first_key))) begin
          rows_q[r] <= with_key(rows_q[r], key_i, lower, lower_later, upper, upper_later,
                                ~stays[r*RowCells+:RowCells], room_before[r]);
        end
      end
    end
  end

  always_comb begin
    count_d = count_q - cleared_o;
    if (insert_i && !replace_i) count_d = count_d + 1'b1;
    if (shift_i) count_d = count_d - 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (rst_i || empty_i) begin
      full_q  <= '0;
      count_q <= '0;
    end else begin
      count_q <= count_d;
      // The first cell with room is filled, whatever moved; the first full cell is taken.
      if (insert_i) full_q <= stays | (stays + 1'b1);
      else if (shift_i) full_q <= full_q & (full_q - 1'b1);
      else full_q <= stays;
    end
  end
  assign count_o = count_q;

  // The first full cell: its row, and its place there.
  logic [RowsPadded-1:0] rows_with_any;
  for (genvar r = 0; r < RowsPadded; r++) begin : gen_any
    if (r < Rows) begin : gen_real
      assign rows_with_any[r] = |full_q[r*RowCells+:RowCells];
    end else begin : gen_padded
      assign rows_with_any[r] = 1'b0;
    end
  end
  logic any, any_in_row;
  first_set #(
      .Width(RowsPadded)
  ) row_encoder (
      .bits_i (rows_with_any),
      .any_o  (any),
      .index_o(first_row)
  );
  logic [RowCells-1:0] shown_full;
  logic [CellBits-1:0] first_cell;
  assign shown_full = full_q[first_row*RowCells+:RowCells];
  first_set #(
      .Width(RowCells)
  ) cell_encoder (
      .bits_i (shown_full),
      .any_o  (any_in_row),
      .index_o(first_cell)
  );
  assign first_o = shown_row[first_cell*KeyWidth+:KeyWidth];

  `CIGSIM_ASSERT(CountTellsWhetherAnyIsFull, any == (count_q != '0) && any == any_in_row)
  `CIGSIM_ASSERT(OneThingAtATime, !(insert_i && (shift_i || empty_i)) && !(replace_i && clear_i))
  `CIGSIM_ASSERT(InsertionFindsRoom, !insert_i || stays != '1)
  `CIGSIM_ASSERT(OnlyFullCellsAreTaken, !shift_i || any)
endmodule
