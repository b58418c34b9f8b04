// SPDX-License-Identifier: MIT
// The sort of a line's crossings along the line (Sandor 1979, sec. 5.3): cells that hold them in
// their order. Rules EO3 and EO4 of docs/machine/edge_orderer.md. Reconstruction: each cell
// compares the crossing that is inserted with its own, and takes the new one or that of a
// neighbour, so that an insertion takes one cycle. While it drains nothing moves: the first full
// cell is shown.
//
// A cell that is cleared keeps its place in the order, empty, until an insertion uses it up: the
// cells between the new crossing's place and the first empty cell move by one towards that. A cell
// that was not used since the memory drained holds ones, which come after every crossing.
//
// For the speed of the simulation a row of cells is one word, in which a cell has 64 bits, and only
// those rows are worked out through which an insertion goes.
`include "rtl/common/assertions.svh"

module sorting_memory #(
    parameter int Crossings = 256,  // a power of two, 4 or more
    parameter int PlaceWidth = 12,  // 25 or less
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
  localparam int RowCells = Crossings < 32 ? Crossings / 2 : 16;
  localparam int Rows = Crossings / RowCells;
  localparam int RowBits = $clog2(Rows);
  localparam int CellBits = $clog2(RowCells);
  localparam int CellWidth = 64;
  localparam int RowWidth = RowCells * CellWidth;

  logic [RowWidth-1:0] rows_q[Rows];
  logic [Crossings-1:0] full_q, stays;
  logic [CountWidth-1:0] count_q, count_d;

  // The last full cell, where all are at the front.
  logic [RowBits-1:0] last_row;
  logic [CellBits-1:0] last_cell;
  assign {last_row, last_cell} = (RowBits + CellBits)'(count_q - 1'b1);
  assign last_o = rows_q[last_row][last_cell*CellWidth+:KeyWidth];

  always_comb begin
    highest_o = '0;
    if (search_i) begin
      for (int i = 0; i < Crossings; i++) begin
        if (full_q[i] && rows_q[i/RowCells][i%RowCells*CellWidth+PlaceWidth+:24] > highest_o) begin
          highest_o = rows_q[i/RowCells][i%RowCells*CellWidth+PlaceWidth+:24];
        end
      end
    end
  end

  // Which cells stay full, but for the new one.
  always_comb begin
    stays = full_q;
    cleared_o = '0;
    if (clear_i) begin
      for (int i = 0; i < Crossings; i++) begin
        if (full_q[i] && rows_q[i/RowCells][i%RowCells*CellWidth+PlaceWidth+:24] >= limit_i) begin
          stays[i] = 1'b0;
          cleared_o = cleared_o + 1'b1;
        end
      end
    end
    if (replace_i) stays[{last_row, last_cell}] = 1'b0;
  end

  // EO3. Between the first cell with a later crossing and the first cell with room each cell takes
  // that of its neighbour, or the new one: upwards where the room comes after the place, downwards
  // where it comes before.
  logic [Crossings-1:0] from_room, up_to_room, stays_above, full_after_first;
  assign from_room = ~(stays & ~(stays + 1'b1));
  assign up_to_room = {~from_room[Crossings-2:0], 1'b1};
  assign stays_above = {1'b0, stays[Crossings-1:1]};
  assign full_after_first = full_q & (full_q - 1'b1);

  // A cell of a row, where cells upwards, or downwards, of the new crossing move.
  function automatic logic [CellWidth-1:0] cell_with(
      input logic [CellWidth-1:0] key, own, below, above, input logic up, down);
    if (key < own) cell_with = !up ? own : key < below ? below : key;
    else cell_with = !down ? own : above < key ? above : key;
  endfunction

  // And whether it is full.
  function automatic logic full_with(input logic [CellWidth-1:0] key, own, above,
                                     input logic full, full_above, up, down);
    if (key < own) full_with = full || up;
    else full_with = !down ? full : key < above || full_above;
  endfunction

  logic emptied;
  logic [CellWidth-1:0] key;
  assign emptied = rst_i || empty_i;
  assign key = CellWidth'(key_i);
  for (genvar r = 0; r < Rows; r++) begin : gen_row
    localparam int Low = r * RowCells;
    localparam int High = Low + RowCells - 1;
    logic [CellWidth-1:0] lowest, highest, below, above;
    assign lowest = rows_q[r][0+:CellWidth];
    assign highest = rows_q[r][RowWidth-1-:CellWidth];
    if (r == 0) begin : gen_no_row_below
      assign below = '0;
    end else begin : gen_row_below
      assign below = rows_q[r-1][RowWidth-1-:CellWidth];
    end
    if (r == Rows - 1) begin : gen_no_row_above
      assign above = '1;
    end else begin : gen_row_above
      assign above = rows_q[r+1][0+:CellWidth];
    end
    // Whether the insertion goes through this row.
    logic moves;
    assign moves = emptied || (insert_i && ((key < highest && up_to_room[Low]) ||
                                            (lowest < key && from_room[High])));
    // `row` and `row_full` are of this process only.
    always_ff @(posedge clk_i) begin : insertion
      logic [RowWidth-1:0] row;
      logic [RowCells-1:0] row_full;
      row_full = stays[Low+:RowCells];
      if (moves) begin
        for (int c = 0; c < RowCells; c++) begin
          row[c*CellWidth+:CellWidth] = cell_with(
              key, rows_q[r][c*CellWidth+:CellWidth],
              c == 0 ? below : rows_q[r][(c+RowCells-1)%RowCells*CellWidth+:CellWidth],
              c == RowCells - 1 ? above : rows_q[r][(c+1)%RowCells*CellWidth+:CellWidth],
              up_to_room[Low+c], from_room[Low+c]);
          row_full[c] = full_with(
              key, rows_q[r][c*CellWidth+:CellWidth],
              c == RowCells - 1 ? above : rows_q[r][(c+1)%RowCells*CellWidth+:CellWidth],
              stays[Low+c], stays_above[Low+c], up_to_room[Low+c], from_room[Low+c]);
        end
        rows_q[r] <= emptied ? '1 : row;
      end
      if (emptied) full_q[Low+:RowCells] <= '0;
      else if (shift_i) full_q[Low+:RowCells] <= full_after_first[Low+:RowCells];
      else full_q[Low+:RowCells] <= row_full;
    end
  end

  always_comb begin
    count_d = count_q - cleared_o;
    if (insert_i && !replace_i) count_d = count_d + 1'b1;
    if (shift_i) count_d = count_d - 1'b1;
  end
  always_ff @(posedge clk_i) begin
    count_q <= emptied ? '0 : count_d;
  end
  assign count_o = count_q;

  // The first full cell: its row, and its place there.
  logic [Rows-1:0] row_any;
  logic [RowCells-1:0] row_full;
  logic [RowBits-1:0] first_row;
  logic [CellBits-1:0] first_cell;
  logic any, any_in_row;
  for (genvar r = 0; r < Rows; r++) begin : gen_any
    assign row_any[r] = |full_q[r*RowCells+:RowCells];
  end
  first_set #(
      .Width(Rows)
  ) row_encoder (
      .bits_i (row_any),
      .any_o  (any),
      .index_o(first_row)
  );
  assign row_full = full_q[first_row*RowCells+:RowCells];
  first_set #(
      .Width(RowCells)
  ) cell_encoder (
      .bits_i (row_full),
      .any_o  (any_in_row),
      .index_o(first_cell)
  );
  assign first_o = rows_q[first_row][first_cell*CellWidth+:KeyWidth];

  `CIGSIM_ASSERT(CountTellsWhetherAnyIsFull, any == (count_q != '0) && any == any_in_row)
  `CIGSIM_ASSERT(OneThingAtATime, !(insert_i && (shift_i || empty_i)) && !(replace_i && clear_i))
  `CIGSIM_ASSERT(InsertionFindsRoom, !insert_i || stays != '1)
  `CIGSIM_ASSERT(OnlyFullCellsAreTaken, !shift_i || any)
endmodule
