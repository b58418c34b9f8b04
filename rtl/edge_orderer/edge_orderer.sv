// SPDX-License-Identifier: MIT
// Edge orderer: for each raster line the crossings of all edges with it, in the order of their
// elements (Stump 1986, ch. II; sorts after Sandor 1979, sec. 5.2 and 5.3). The rules EO1 to EO12
// are those of docs/machine/edge_orderer.md; all registers and timing are reconstruction.
//
// The load side puts the edges of the next picture into one bank of the edge and bucket memories.
// The line side reads the other bank, and fills one sorting memory while the other drains.
`include "rtl/common/assertions.svh"

module edge_orderer #(
    parameter int Edges = 4096,    // of a picture, 2 or more
    parameter int Lines = 1024,    // of the raster, 2 to 8192
    parameter int Crossings = 256  // cells of a sorting memory: a power of two, 4 or more
) (
    input logic        clk_i,
    input logic        rst_i,
    // Taken over while the reset lasts. Of the raster, 1 or more:
    input logic [13:0] cfg_width_i,
    input logic [13:0] cfg_height_i,
    input logic [31:0] cfg_crossing_capacity_i,  // 0: no limit
    input logic [ 1:0] cfg_policy_i,             // 0 drop, 1 cut, 2 extend

    input  logic        edges_valid_i,
    input  logic [23:0] edges_face_i,
    input  logic [13:0] edges_first_line_i,
    input  logic [13:0] edges_end_line_i,
    input  logic        edges_left_i,
    input  logic        edges_end_i,
    input  logic [31:0] edges_x_i,
    input  logic [31:0] edges_slope_i,
    output logic        edges_ready_o,

    output logic        loaded_valid_o,
    output logic [31:0] loaded_frame_o,
    input  logic        loaded_ready_i,

    input  logic        start_valid_i,
    input  logic [31:0] start_frame_i,
    output logic        start_ready_o,

    output logic        crossings_valid_o,
    output logic [23:0] crossings_face_o,
    output logic [13:0] crossings_element_o,
    output logic        crossings_left_o,
    output logic        crossings_end_o,
    output logic        crossings_cut_o,
    input  logic        crossings_ready_i,

    // What happens in this cycle; no input of this cycle matters to it.
    output logic        mon_pass_o,        // a pass begins
    output logic        mon_line_o,        // with it a line
    output logic [31:0] mon_crossings_o,   // of that line
    output logic        mon_overfull_o,    // a line ends that had more crossings than the capacity
    output logic [31:0] mon_dropped_o,     // so many crossings are dropped or cut
    output logic        mon_overflow_o,    // an edge is stepped, and saturates
    // Ever since reset: edges, lines or crossings came that the parameters have no room for.
    output logic        mon_too_small_o
);
  localparam int PlaceWidth = $clog2(Edges);
  localparam int EdgeCountWidth = $clog2(Edges + 1);
  localparam int LineWidth = $clog2(Lines);
  localparam int CountWidth = $clog2(Crossings + 1);
  localparam int KeyWidth = 14 + 1 + 24 + PlaceWidth;
  localparam logic [1:0] Extend = 2'd2;

  // The configuration, as it is while the reset lasts.
  logic [13:0] width_q, height_q;
  logic [31:0] capacity_q;
  logic [1:0] policy_q;
  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      width_q <= cfg_width_i;
      height_q <= cfg_height_i;
      capacity_q <= cfg_crossing_capacity_i;
      policy_q <= cfg_policy_i;
    end
  end

  // Load side (EO5, EO6).
  logic loading_q;
  logic [31:0] load_frame_q;
  logic [EdgeCountWidth-1:0] load_count_q;
  logic add, no_place;
  logic [PlaceWidth-1:0] load_place;
  assign edges_ready_o = loading_q;
  assign loaded_valid_o = !loading_q;
  assign loaded_frame_o = load_frame_q;
  assign no_place = load_count_q == EdgeCountWidth'(Edges);
  assign load_place = load_count_q[PlaceWidth-1:0];
  assign add = loading_q && edges_valid_i && !edges_end_i && !no_place;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      loading_q <= 1'b1;
      load_frame_q <= '0;
      load_count_q <= '0;
    end else if (loading_q) begin
      if (edges_valid_i && edges_end_i) loading_q <= 1'b0;
      if (add) load_count_q <= load_count_q + 1'b1;
    end else if (loaded_ready_i) begin
      loading_q <= 1'b1;
      load_frame_q <= load_frame_q + 1'b1;
      load_count_q <= '0;
    end
  end

  // Line side, filling.
  localparam logic [2:0] Idle = 3'd0, Begin = 3'd1, Insert = 3'd2, Wait = 3'd3, Done = 3'd4;
  logic [2:0] fill_q, fill_d;
  logic bank_q;
  logic [13:0] line_q, next_line;
  logic fill_memory_q;                     // which sorting memory
  logic again_q;                           // the pass is not the line's first
  logic [EdgeCountWidth-1:0] unpassed_q;   // crossings of the line beyond those of passes before
  logic [EdgeCountWidth-1:0] remaining_q;  // crossings of the pass still to insert
  logic [EdgeCountWidth-1:0] in_bucket_q;  // how many of these are from the bucket,
  logic [PlaceWidth-1:0] bucket_place_q;   // and the place of the first

  logic begins, inserts, pass_end, line_end, last_pass;
  logic [EdgeCountWidth-1:0] crossings, unpassed;
  logic [EdgeCountWidth-1:0] in_list, in_bucket;
  assign begins = fill_q == Begin;
  assign inserts = fill_q == Insert;
  assign crossings = in_bucket + in_list;
  assign unpassed = begins && !again_q ? crossings : unpassed_q;
  assign last_pass = policy_q != Extend || capacity_q == '0 ||
      32'(unpassed) <= capacity_q;
  assign pass_end = (begins && crossings == '0) || (inserts && remaining_q == EdgeCountWidth'(1));
  assign line_end = pass_end && last_pass;
  assign next_line = line_q + 1'b1;

  // The memories of the bank that is read, of which both read.
  logic [PlaceWidth-1:0] place, list_place;
  logic from_bucket, step;
  assign from_bucket = in_bucket_q != '0;
  assign place = from_bucket ? bucket_place_q : list_place;

  logic [31:0] stepped_x;
  for (genvar b = 0; b < 2; b++) begin : gen_bank
    logic [23:0] face;
    logic left;
    logic [13:0] end_line;
    logic [31:0] x, slope;
    logic [PlaceWidth-1:0] next, behind, first;
    logic [EdgeCountWidth-1:0] count;
    logic loads, reads;
    assign loads = add && load_frame_q[0] == b;
    assign reads = bank_q == b;
    edge_memory #(
        .Edges(Edges)
    ) edges (
        .clk_i           (clk_i),
        .write_i         (loads),
        .write_place_i   (load_place),
        .write_face_i    (edges_face_i),
        .write_left_i    (edges_left_i),
        .write_end_line_i(edges_end_line_i),
        .write_x_i       (edges_x_i),
        .write_slope_i   (edges_slope_i),
        .write_next_i    (behind),
        .place_i         (place),
        .face_o          (face),
        .left_o          (left),
        .end_line_o      (end_line),
        .x_o             (x),
        .slope_o         (slope),
        .next_o          (next),
        .step_i          (step && reads),
        .step_x_i        (stepped_x)
    );
    bucket_memory #(
        .Edges(Edges),
        .Lines(Lines)
    ) buckets (
        .clk_i      (clk_i),
        .rst_i      (rst_i),
        .add_i      (loads),
        .add_line_i (edges_first_line_i[LineWidth-1:0]),
        .add_place_i(load_place),
        .behind_o   (behind),
        .line_i     (line_q[LineWidth-1:0]),
        .first_o    (first),
        .count_o    (count),
        .empty_i    (line_end && reads)
    );
  end
  logic [23:0] read_face;
  logic read_left;
  logic [13:0] read_end_line;
  logic [31:0] read_x, read_slope;
  logic [PlaceWidth-1:0] read_next, bucket_first;
  assign read_face = bank_q ? gen_bank[1].face : gen_bank[0].face;
  assign read_left = bank_q ? gen_bank[1].left : gen_bank[0].left;
  assign read_end_line = bank_q ? gen_bank[1].end_line : gen_bank[0].end_line;
  assign read_x = bank_q ? gen_bank[1].x : gen_bank[0].x;
  assign read_slope = bank_q ? gen_bank[1].slope : gen_bank[0].slope;
  assign read_next = bank_q ? gen_bank[1].next : gen_bank[0].next;
  assign bucket_first = bank_q ? gen_bank[1].first : gen_bank[0].first;
  assign in_bucket = bank_q ? gen_bank[1].count : gen_bank[0].count;

  // EO1, EO2, EO10, EO11.
  logic saturates;
  logic [13:0] element;
  logic [KeyWidth-1:0] key;
  edge_stepper stepper (
      .width_i    (width_q),
      .x_i        (read_x),
      .slope_i    (read_slope),
      .element_o  (element),
      .x_o        (stepped_x),
      .saturated_o(saturates)
  );
  assign step = inserts && last_pass && read_end_line > next_line;
  assign key = {element, read_left, read_face, place};

  active_list #(
      .Edges(Edges)
  ) list (
      .clk_i     (clk_i),
      .rst_i     (rst_i),
      .count_o   (in_list),
      .place_o   (list_place),
      .read_i    (inserts && !from_bucket),
      .write_i   (step),
      .place_i   (place),
      .pass_end_i(pass_end),
      .line_end_i(line_end)
  );

  // EO4. What a sorting memory tells matters while it is filled, or right after that.
  logic [CountWidth-1:0] fill_count, fill_cleared;
  logic [KeyWidth-1:0] fill_last, pass_last;
  logic [23:0] fill_highest;
  assign fill_count = fill_memory_q ? gen_sorting[1].count : gen_sorting[0].count;
  assign fill_cleared = fill_memory_q ? gen_sorting[1].cleared : gen_sorting[0].cleared;
  assign fill_last = fill_memory_q ? gen_sorting[1].last : gen_sorting[0].last;
  assign pass_last = fill_memory_q ? gen_sorting[0].last : gen_sorting[1].last;
  assign fill_highest = fill_memory_q ? gen_sorting[1].highest : gen_sorting[0].highest;
  logic search, insert, replace, clear, overfull, cut, no_cell;
  logic [23:0] limit;
  logic [13:0] rest;
  logic [CountWidth:0] dropped;
  line_overload #(
      .Crossings (Crossings),
      .PlaceWidth(PlaceWidth)
  ) overload (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .policy_i   (policy_q),
      .capacity_i (capacity_q),
      .crossing_i (inserts),
      .key_i      (key),
      .pass_end_i (pass_end),
      .line_end_i (line_end),
      .count_i    (fill_count),
      .last_i     (fill_last),
      .highest_i  (fill_highest),
      .cleared_i  (fill_cleared),
      .search_o   (search),
      .insert_o   (insert),
      .replace_o  (replace),
      .clear_o    (clear),
      .limit_o    (limit),
      .pass_last_i(pass_last),
      .overfull_o (overfull),
      .cut_o      (cut),
      .rest_o     (rest),
      .dropped_o  (dropped),
      .too_small_o(no_cell)
  );

  // Line side, draining (EO12).
  logic drain_memory_q;
  logic [1:0] filled_q, filled_d, ends_line_q, cut_q;
  logic [13:0] rest_q[2];
  logic [13:0] drain_line_q;
  logic [CountWidth-1:0] drain_count;
  logic [KeyWidth-1:0] shown;
  logic offered, end_word, taken, drained, picture_end;
  assign drain_count = drain_memory_q ? gen_sorting[1].count : gen_sorting[0].count;
  assign shown = drain_memory_q ? gen_sorting[1].first : gen_sorting[0].first;
  assign offered = filled_q[drain_memory_q];
  assign end_word = drain_count == '0;
  assign taken = offered && crossings_ready_i;
  assign drained = taken && (end_word ||
      (drain_count == CountWidth'(1) && !ends_line_q[drain_memory_q]));
  assign picture_end = drained && end_word && drain_line_q + 1'b1 == height_q;

  for (genvar m = 0; m < 2; m++) begin : gen_sorting
    logic fills, drains;
    logic [CountWidth-1:0] count, cleared;
    logic [KeyWidth-1:0] last, first;
    logic [23:0] highest;
    assign fills = fill_memory_q == m;
    assign drains = drain_memory_q == m;
    sorting_memory #(
        .Crossings (Crossings),
        .PlaceWidth(PlaceWidth)
    ) memory (
        .clk_i    (clk_i),
        .rst_i    (rst_i),
        .insert_i (insert && fills),
        .key_i    (key),
        .replace_i(replace && fills),
        .clear_i  (clear && fills),
        .limit_i  (limit),
        .count_o  (count),
        .last_o   (last),
        .search_i (search && fills),
        .highest_o(highest),
        .cleared_o(cleared),
        .first_o  (first),
        .shift_i  (taken && !end_word && drains),
        .empty_i  (drained && drains)
    );
    assign filled_d[m] = (filled_q[m] && !(drained && drains)) || (pass_end && fills);
    always_ff @(posedge clk_i) begin
      if (pass_end && fills) begin
        ends_line_q[m] <= last_pass;
        cut_q[m] <= cut;
        rest_q[m] <= rest;
      end
    end
  end

  assign crossings_valid_o = offered;
  assign crossings_end_o = end_word;
  assign crossings_cut_o = end_word && cut_q[drain_memory_q];
  assign crossings_element_o = !end_word ? shown[KeyWidth-1-:14] :
      crossings_cut_o ? rest_q[drain_memory_q] : '0;
  assign crossings_left_o = !end_word && shown[KeyWidth-15];
  assign crossings_face_o = end_word ? '0 : shown[PlaceWidth+:24];

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      filled_q <= '0;
      drain_memory_q <= 1'b0;
      drain_line_q <= '0;
    end else begin
      filled_q <= filled_d;
      if (drained) drain_memory_q <= !drain_memory_q;
      if (picture_end) drain_line_q <= '0;
      else if (drained && end_word) drain_line_q <= drain_line_q + 1'b1;
    end
  end

  // EO7 to EO9. The next pass waits for the memory that it fills.
  assign start_ready_o = fill_q == Idle;
  always_comb begin
    fill_d = fill_q;
    if (fill_q == Idle) begin
      if (start_valid_i) fill_d = Begin;
    end else if (pass_end) begin
      if (line_end && next_line == height_q) fill_d = Done;
      else fill_d = filled_d[!fill_memory_q] ? Wait : Begin;
    end else if (begins) begin
      fill_d = Insert;
    end else if (fill_q == Wait) begin
      if (!filled_d[fill_memory_q]) fill_d = Begin;
    end else if (picture_end) begin
      fill_d = Idle;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      fill_q <= Idle;
      fill_memory_q <= 1'b0;
      line_q <= '0;
      again_q <= 1'b0;
      in_bucket_q <= '0;
    end else begin
      fill_q <= fill_d;
      if (pass_end) begin
        fill_memory_q <= !fill_memory_q;
        again_q <= !last_pass;
      end
      if (line_end) line_q <= fill_d == Done ? '0 : next_line;
      if (begins) in_bucket_q <= in_bucket;
      else if (inserts && from_bucket) in_bucket_q <= in_bucket_q - 1'b1;
    end
    if (fill_q == Idle) bank_q <= start_frame_i[0];
    if (begins) bucket_place_q <= bucket_first;
    else if (from_bucket) bucket_place_q <= read_next;
    remaining_q <= begins ? crossings : remaining_q - 1'b1;
    if (pass_end) unpassed_q <= unpassed - capacity_q[EdgeCountWidth-1:0];
    else if (begins) unpassed_q <= unpassed;
  end

  assign mon_pass_o = begins;
  assign mon_line_o = begins && !again_q;
  assign mon_crossings_o = 32'(crossings);
  assign mon_overfull_o = line_end && overfull;
  assign mon_dropped_o = 32'(dropped);
  assign mon_overflow_o = step && saturates;

  logic too_small_q;
  assign mon_too_small_o = too_small_q;
  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      too_small_q <= 32'(cfg_height_i) > Lines;
    end else if (no_cell || (loading_q && edges_valid_i && !edges_end_i && no_place)) begin
      too_small_q <= 1'b1;
    end
  end

  `CIGSIM_ASSERT(EdgesInTheRaster, !add || (edges_first_line_i < edges_end_line_i &&
                                            edges_end_line_i <= height_q))
  `CIGSIM_ASSERT(StartsWhatIsLoaded, !(start_ready_o && start_valid_i) ||
                                     (start_frame_i < load_frame_q &&
                                      load_frame_q - start_frame_i <= 32'd2))
  `CIGSIM_ASSERT(LoadsTheOtherBank, !(add && fill_q != Idle) || load_frame_q[0] != bank_q)
  `CIGSIM_ASSERT(PictureEndsWithAnEmptyList, fill_q != Done || in_list == '0)
  `CIGSIM_ASSERT(OnePassIsFilledAtATime, !inserts || !filled_q[fill_memory_q])
  `CIGSIM_ASSERT(FurtherPassesFollowFullOnes,
                 !offered || !end_word || ends_line_q[drain_memory_q])
`ifdef CIGSIM_ASSERTIONS
  crossing_check crossing_check (
      .clk_i    (clk_i),
      .rst_i    (rst_i),
      .width_i  (width_q),
      .valid_i  (crossings_valid_o),
      .ready_i  (crossings_ready_i),
      .face_i   (crossings_face_o),
      .element_i(crossings_element_o),
      .left_i   (crossings_left_o),
      .end_i    (crossings_end_o),
      .cut_i    (crossings_cut_o)
  );
`endif
endmodule
