// SPDX-License-Identifier: MIT
// Microinstructions of the priority processor: where each field lies in a word, and the codes of its
// values, as firmware/priority_processor/format.fmt declares them. A test compares every line here
// with that file.
//
// For use within a module. A field is word[NAMELsb +: NAMEBits]; a value's name is the field's and
// its own. The codes of the sequencer's instructions are in microsequencer.sv.

// A value that does nothing (HOLD, NONE, TRUE) is declared for completeness; the default of a case
// stands for it.
/* verilator lint_off UNUSEDPARAM */
localparam int MicrowordBits = 53;

localparam int OpLsb = 0;
localparam int OpBits = 4;

localparam int PolLsb = 4;
localparam int PolBits = 1;

localparam int DLsb = 5;
localparam int DBits = 1;
localparam logic [0:0] DWord = 1'd0;
localparam logic [0:0] DData = 1'd1;

localparam int AddressLsb = 6;
localparam int AddressBits = 12;

localparam int CondLsb = 18;
localparam int CondBits = 4;
localparam logic [3:0] CondTrue = 4'd0;
localparam logic [3:0] CondStart = 4'd1;
localparam logic [3:0] CondZero = 4'd2;
localparam logic [3:0] CondBit31 = 4'd3;
localparam logic [3:0] CondMany = 4'd4;
localparam logic [3:0] CondPlanes = 4'd5;
localparam logic [3:0] CondMembers = 4'd6;
localparam logic [3:0] CondFault = 4'd7;
localparam logic [3:0] CondLastRank = 4'd8;
localparam logic [3:0] CondOpened = 4'd9;
localparam logic [3:0] CondInside = 4'd10;
localparam logic [3:0] CondFull = 4'd11;
localparam logic [3:0] CondGrounds = 4'd12;

localparam int TakeLsb = 22;
localparam int TakeBits = 1;

localparam int SrcLsb = 23;
localparam int SrcBits = 3;
localparam logic [2:0] SrcNone = 3'd0;
localparam logic [2:0] SrcMem = 3'd1;
localparam logic [2:0] SrcBank = 3'd2;
localparam logic [2:0] SrcOrder = 3'd3;
localparam logic [2:0] SrcT = 3'd4;

localparam int LoadLsb = 26;
localparam int LoadBits = 4;
localparam logic [3:0] LoadNone = 4'd0;
localparam logic [3:0] LoadEyeX = 4'd1;
localparam logic [3:0] LoadEyeY = 4'd2;
localparam logic [3:0] LoadEyeZ = 4'd3;
localparam logic [3:0] LoadDirectory = 4'd4;
localparam logic [3:0] LoadGround = 4'd5;
localparam logic [3:0] LoadMaskLow = 4'd6;
localparam logic [3:0] LoadMaskHigh = 4'd7;
localparam logic [3:0] LoadChild = 4'd8;
localparam logic [3:0] LoadMembers = 4'd9;
localparam logic [3:0] LoadPlanes = 4'd10;
localparam logic [3:0] LoadT = 4'd11;

localparam int MarLsb = 30;
localparam int MarBits = 2;
localparam logic [1:0] MarHold = 2'd0;
localparam logic [1:0] MarInc = 2'd1;
localparam logic [1:0] MarLoad = 2'd2;
localparam logic [1:0] MarMember = 2'd3;

localparam int BarLsb = 32;
localparam int BarBits = 2;
localparam logic [1:0] BarHold = 2'd0;
localparam logic [1:0] BarInc = 2'd1;
localparam logic [1:0] BarLoad = 2'd2;
localparam logic [1:0] BarItem = 2'd3;

localparam int AccLsb = 34;
localparam int AccBits = 3;
localparam logic [2:0] AccHold = 3'd0;
localparam logic [2:0] AccX = 3'd1;
localparam logic [2:0] AccY = 3'd2;
localparam logic [2:0] AccZ = 3'd3;
localparam logic [2:0] AccLow = 3'd4;
localparam logic [2:0] AccHigh = 3'd5;

localparam int CountLsb = 37;
localparam int CountBits = 2;
localparam logic [1:0] CountHold = 2'd0;
localparam logic [1:0] CountClear = 2'd1;
localparam logic [1:0] CountPair = 2'd2;

localparam int RestLsb = 39;
localparam int RestBits = 2;
localparam logic [1:0] RestHold = 2'd0;
localparam logic [1:0] RestLoad = 2'd1;
localparam logic [1:0] RestNext = 2'd2;

localparam int ListLsb = 41;
localparam int ListBits = 2;
localparam logic [1:0] ListHold = 2'd0;
localparam logic [1:0] ListClear = 2'd1;
localparam logic [1:0] ListCount = 2'd2;
localparam logic [1:0] ListRank = 2'd3;

localparam int RankLsb = 43;
localparam int RankBits = 2;
localparam logic [1:0] RankHold = 2'd0;
localparam logic [1:0] RankClear = 2'd1;
localparam logic [1:0] RankInc = 2'd2;

localparam int LevelLsb = 45;
localparam int LevelBits = 2;
localparam logic [1:0] LevelHold = 2'd0;
localparam logic [1:0] LevelInc = 2'd1;
localparam logic [1:0] LevelDec = 2'd2;

localparam int PlaceLsb = 47;
localparam int PlaceBits = 2;
localparam logic [1:0] PlaceHold = 2'd0;
localparam logic [1:0] PlaceBegin = 2'd1;
localparam logic [1:0] PlaceNext = 2'd2;

localparam int PlanesLsb = 49;
localparam int PlanesBits = 1;

localparam int PutLsb = 50;
localparam int PutBits = 2;
localparam logic [1:0] PutNone = 2'd0;
localparam logic [1:0] PutItem = 2'd1;
localparam logic [1:0] PutGround = 2'd2;
localparam logic [1:0] PutEnd = 2'd3;

localparam int FaultLsb = 52;
localparam int FaultBits = 1;
/* verilator lint_on UNUSEDPARAM */
