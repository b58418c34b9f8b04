// SPDX-License-Identifier: MIT
// One step of control_store: an instruction is at the address where it was written, and nothing else
// is written.
// registers: store_q[WordsxWidth]
module control_store_proof #(
    parameter int Width = 53,
    parameter int Words = 64,
    localparam int AddressWidth = $clog2(Words)
) (
    input logic        clk_i,
    input logic        second_i,
    input logic        write_i,
    input logic [AddressWidth-1:0] address_i,
    input logic [Width-1:0] word_i,
    input logic [11:0] read_i,
    input logic [AddressWidth-1:0] watched_i,

    input logic [Words*Width-1:0] store_q,
    output logic         ok_o
);
  logic [Width-1:0] read;
  control_store #(.Width(Width), .Words(Words)) dut (
      .clk_i(clk_i), .rst_i(1'b1), .image_write_i(write_i), .image_address_i(address_i),
      .image_word_i(word_i), .micro_address_i(read_i), .word_o(read)
  );

  // Any word is watched.
  logic [Width-1:0] at_read, at_watched, at_watched_n, after;
  logic [AddressWidth-1:0] watched_n;
  always_comb begin
    at_read = '0;
    at_watched = '0;
    at_watched_n = '0;
    for (int n = 0; n < Words; n++) begin
      if (read_i[AddressWidth-1:0] == n) at_read = store_q[n*Width+:Width];
      if (watched_i == n) at_watched = store_q[n*Width+:Width];
      if (watched_n == n) at_watched_n = store_q[n*Width+:Width];
    end
  end
  always_ff @(posedge clk_i) begin
    watched_n <= watched_i;
    after <= write_i && address_i == watched_i ? word_i : at_watched;
  end
  assign ok_o = second_i ? at_watched_n == after : read == at_read;
endmodule
