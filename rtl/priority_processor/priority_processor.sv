// SPDX-License-Identifier: MIT
// Priority processor: the list of items from the highest priority to the lowest, by separation
// planes, a counter an object and the check that the counts are unique (Stump 1986, ch. II and III).
// A data path that does nothing by itself; the microprogram of firmware/priority_processor says
// clock by clock what each part of it does. The data path, the microprogram, all layouts and all
// timing are reconstruction; docs/machine/priority_processor.md describes and numbers them.
//
// Database memory and banks are outside. Their addresses are registers, and the words at them are
// read in the same clock. Outputs mon_… tell what the instruction of the clock before did.
`include "rtl/common/assertions.svh"

module priority_processor #(
    parameter int Members = 64,  // of a group, 2 to 64
    parameter int Levels = 64,   // depth of groups, 1 or more
    localparam int ImageBits = 53,
    localparam int ImageWords = 64,
    localparam int ImageWidth = $clog2(ImageWords)
) (
    input logic clk_i,
    input logic rst_i,

    input logic [31:0] cfg_object_capacity_i,  // items at most; 0: no limit

    // The microprogram, written in reset, the last word last.
    input logic                  image_write_i,
    input logic [ImageWidth-1:0] image_address_i,
    input logic [ ImageBits-1:0] image_word_i,

    input  logic        start_valid_i,
    input  logic [31:0] start_frame_i,
    output logic        start_ready_o,

    output logic        items_valid_o,
    output logic [ 1:0] items_set_o,    // 0 static, 1 moving, 2 ground
    output logic [29:0] items_item_o,
    output logic        items_end_o,
    input  logic        items_ready_i,

    output logic [31:0] memory_address_o,
    input  logic [31:0] memory_word_i,
    output logic        bank_o,
    output logic [31:0] bank_address_o,
    input  logic [31:0] bank_word_i,

    output logic [31:0] mon_frame_o,    // that is worked
    output logic [31:0] mon_record_o,   // of the group that was entered last
    output logic        mon_stalled_o,  // the instruction waited for the output register
    output logic        mon_dropped_o,  // an item was dropped
    output logic        mon_group_o,    // a group was ordered
    output logic        mon_plane_o,    // a plane was tested
    output logic        mon_pair_o,     // a pair was looked at
    output logic        mon_fault_o     // the group's counts were not unique
);
  localparam int MemberWidth = $clog2(Members);
  localparam int ListedWidth = $clog2(Members + 1);
  `include "rtl/priority_processor/microword.svh"

  // --- The microinstruction, its fields apart.

  logic [11:0] micro_address_q;  // register of the sequencer
  logic [MicrowordBits-1:0] word;
  control_store #(
      .Width(MicrowordBits),
      .Words(ImageWords)
  ) control_store (
      .clk_i          (clk_i),
      .rst_i          (rst_i),
      .image_write_i  (image_write_i),
      .image_address_i(image_address_i),
      .image_word_i   (image_word_i),
      .micro_address_i(micro_address_q),
      .word_o         (word)
  );

  logic [OpBits-1:0] op;
  logic pol, d, take, planes_count, fault_report;
  logic [AddressBits-1:0] address;
  logic [CondBits-1:0] cond;
  logic [SrcBits-1:0] src;
  logic [LoadBits-1:0] load;
  logic [MarBits-1:0] mar;
  logic [BarBits-1:0] bar;
  logic [AccBits-1:0] acc;
  logic [CountBits-1:0] count;
  logic [RestBits-1:0] rest;
  logic [ListBits-1:0] list;
  logic [RankBits-1:0] rank;
  logic [LevelBits-1:0] level;
  logic [PlaceBits-1:0] place;
  logic [PutBits-1:0] put;
  assign op = word[OpLsb+:OpBits];
  assign pol = word[PolLsb+:PolBits];
  assign d = word[DLsb+:DBits];
  assign address = word[AddressLsb+:AddressBits];
  assign cond = word[CondLsb+:CondBits];
  assign take = word[TakeLsb+:TakeBits];
  assign src = word[SrcLsb+:SrcBits];
  assign load = word[LoadLsb+:LoadBits];
  assign mar = word[MarLsb+:MarBits];
  assign bar = word[BarLsb+:BarBits];
  assign acc = word[AccLsb+:AccBits];
  assign count = word[CountLsb+:CountBits];
  assign rest = word[RestLsb+:RestBits];
  assign list = word[ListLsb+:ListBits];
  assign rank = word[RankLsb+:RankBits];
  assign level = word[LevelLsb+:LevelBits];
  assign place = word[PlaceLsb+:PlaceBits];
  assign planes_count = word[PlanesLsb+:PlanesBits];
  assign put = word[PutLsb+:PutBits];
  assign fault_report = word[FaultLsb+:FaultBits];

  // --- The start word, and the bus.

  logic take_frame;
  assign start_ready_o = take;
  assign take_frame = take && start_valid_i && !rst_i;

  logic [31:0] bus, order_entry, t_q;
  always_comb begin
    unique case (src)
      SrcMem: bus = memory_word_i;
      SrcBank: bus = bank_word_i;
      SrcOrder: bus = order_entry;
      SrcT: bus = t_q;
      default: bus = '0;
    endcase
  end

  // --- Counters, members, groups, and the output.

  logic eye_true;
  /* verilator lint_off PINCONNECTEMPTY */  // the sum itself is for waves and tests of the part
  plane_side plane_side (
      .clk_i        (clk_i),
      .rst_i        (rst_i),
      .load_eye_i   ({load == LoadEyeZ, load == LoadEyeY, load == LoadEyeX}),
      .product_i    ({acc == AccZ, acc == AccY, acc == AccX}),
      .take_low_i   (acc == AccLow),
      .take_high_i  (acc == AccHigh),
      .word_i       (bus),
      .eye_true_o   (eye_true),
      .accumulator_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */

  logic [Members-1:0] active;
  logic many, members_left;
  logic [MemberWidth-1:0] first_left;
  logic [31:0] entry;
  active_members #(
      .Members(Members)
  ) active_members (
      .clk_i       (clk_i),
      .rst_i       (rst_i),
      .load_low_i  (load == LoadMaskLow),
      .load_high_i (load == LoadMaskHigh),
      .load_child_i(load == LoadChild),
      .rest_load_i (rest == RestLoad),
      .rest_next_i (rest == RestNext),
      .word_i      (bus),
      .active_o    (active),
      .many_o      (many),
      .any_left_o  (members_left),
      .first_left_o(first_left),
      .entry_o     (entry)
  );

  logic [5:0] rank_q;
  logic list_now, fault;
  logic [MemberWidth-1:0] list_place;
  logic [ListedWidth-1:0] listed;
  object_counters #(
      .Members(Members)
  ) object_counters (
      .clk_i         (clk_i),
      .rst_i         (rst_i),
      .clear_i       (count == CountClear),
      .pair_i        (count == CountPair),
      .true_member_i (bus[5:0]),
      .false_member_i(bus[13:8]),
      .eye_true_i    (eye_true),
      .active_i      (active),
      .list_clear_i  (list == ListClear),
      .list_count_i  (list == ListCount),
      .list_rank_i   (list == ListRank),
      .member_i      (first_left),
      .rank_i        (rank_q),
      .list_o        (list_now),
      .place_o       (list_place),
      .listed_o      (listed),
      .fault_o       (fault)
  );

  logic opened, inside_group;
  group_places #(
      .Members(Members),
      .Levels (Levels)
  ) group_places (
      .clk_i          (clk_i),
      .rst_i          (rst_i),
      .level_outside_i(take_frame),
      .level_inc_i    (level == LevelInc),
      .level_dec_i    (level == LevelDec),
      .entry_write_i  (list_now),
      .entry_place_i  (list_place),
      .entry_i        (entry),
      .place_begin_i  (place == PlaceBegin),
      .place_next_i   (place == PlaceNext),
      .number_i       (listed),
      .entry_o        (order_entry),
      .opened_o       (opened),
      .inside_o       (inside_group)
  );

  logic full, drop, grounds_left;
  item_output item_output (
      .clk_i                (clk_i),
      .rst_i                (rst_i),
      .cfg_object_capacity_i(cfg_object_capacity_i),
      .clear_i              (take_frame),
      .put_item_i           (put == PutItem),
      .put_ground_i         (put == PutGround),
      .put_end_i            (put == PutEnd),
      .load_grounds_i       (load == LoadGround),
      .word_i               (bus),
      .full_o               (full),
      .drop_o               (drop),
      .grounds_o            (grounds_left),
      .item_valid_o         (items_valid_o),
      .item_set_o           (items_set_o),
      .item_o               (items_item_o),
      .item_end_o           (items_end_o),
      .item_ready_i         (items_ready_i)
  );

  // --- The other registers.

  logic [31:0] directory_q, members_q, planes_q, record_q, frame_q;
  always_ff @(posedge clk_i) begin
    if (load == LoadDirectory) directory_q <= bus;
    if (load == LoadMembers) members_q <= bus;
    if (load == LoadPlanes) planes_q <= bus;
    else if (planes_count) planes_q <= planes_q - 32'd1;
    if (load == LoadT) t_q <= bus;
    if (rank == RankClear) rank_q <= '0;
    else if (rank == RankInc) rank_q <= rank_q + 6'd1;
    if (take_frame) frame_q <= start_frame_i;
  end

  logic [31:0] mar_q, mar_d, bar_q, bar_d;
  always_comb begin
    unique case (mar)
      MarInc: mar_d = mar_q + 32'd1;
      MarLoad: mar_d = bus;
      MarMember: mar_d = members_q + 32'(first_left);
      default: mar_d = mar_q;
    endcase
    unique case (bar)
      BarInc: bar_d = bar_q + 32'd1;
      BarLoad: bar_d = {1'b0, bus[30:0]};
      BarItem: bar_d = bus[31] ? {1'b0, bus[30:0]} : directory_q + 32'(bus[29:0]);
      default: bar_d = bar_q;
    endcase
    if (take_frame) bar_d = '0;
  end
  always_ff @(posedge clk_i) begin
    mar_q <= mar_d;
    bar_q <= bar_d;
    if (level == LevelInc) record_q <= bar_q;
  end
  assign memory_address_o = mar_q;
  assign bank_address_o = bar_q;
  assign bank_o = frame_q[0];

  // --- What comes next.

  logic condition;
  always_comb begin
    unique case (cond)
      CondStart: condition = start_valid_i;
      CondZero: condition = bus == '0;
      CondBit31: condition = bus[31];
      CondMany: condition = many;
      CondPlanes: condition = planes_q != '0;
      CondMembers: condition = members_left;
      CondFault: condition = fault;
      CondLastRank: condition = rank_q == '1;
      CondOpened: condition = opened;
      CondInside: condition = inside_group;
      CondFull: condition = full;
      CondGrounds: condition = grounds_left;
      default: condition = 1'b1;
    endcase
  end
  /* verilator lint_off PINCONNECTEMPTY */  // its other registers are for tests of the part
  microsequencer sequencer (
      .clk_i          (clk_i),
      .rst_i          (rst_i),
      .op_i           (op),
      .pass_i         (condition != pol),
      .d_i            (d == DData ? bus[11:0] : address),
      .micro_address_o(micro_address_q),
      .counter_o      (),
      .stack_top_o    (),
      .stack_level_o  ()
  );
  /* verilator lint_on PINCONNECTEMPTY */

  always_ff @(posedge clk_i) begin
    mon_stalled_o <= full && cond == CondFull;
    mon_dropped_o <= drop;
    mon_group_o <= place == PlaceBegin;
    mon_plane_o <= acc == AccHigh;
    mon_pair_o <= count == CountPair;
    mon_fault_o <= fault_report;
  end
  assign mon_frame_o = frame_q;
  assign mon_record_o = record_q;

  `CIGSIM_ASSERT(conditions_exist, cond <= CondGrounds)
  `CIGSIM_ASSERT(sources_exist, src <= SrcT)
  `CIGSIM_ASSERT(planes_are_left, !planes_count || planes_q != '0)
endmodule
