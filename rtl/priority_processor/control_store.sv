// SPDX-License-Identifier: MIT
// Control store: the microinstructions, read in the clock in which they are executed. The image of
// firmware/ is written through the pins while the machine is in reset. Its size is reconstruction
// (docs/machine/priority_processor.md); a machine of the time had read-only memories here.
`include "rtl/common/assertions.svh"

module control_store #(
    parameter int Width = 53,  // bits of a microinstruction
    parameter int Words = 64,  // a power of two
    localparam int AddressWidth = $clog2(Words)
) (
    input logic clk_i,
    input logic rst_i,

    input logic                    image_write_i,
    input logic [AddressWidth-1:0] image_address_i,
    input logic [       Width-1:0] image_word_i,

    input  logic [     11:0] micro_address_i,
    output logic [Width-1:0] word_o
);
  logic [Width-1:0] store_q[Words];

  always_ff @(posedge clk_i) if (image_write_i) store_q[image_address_i] <= image_word_i;

  assign word_o = store_q[micro_address_i[AddressWidth-1:0]];

`ifdef CIGSIM_ASSERTIONS
  // How far the image goes: what lies beyond must not be executed.
  logic [11:0] last_q;
  always_ff @(posedge clk_i) begin
    if (image_write_i) last_q <= 12'(image_address_i);
  end
`endif
  `CIGSIM_ASSERT(image_is_written_in_reset, !image_write_i)
  `CIGSIM_ASSERT(address_in_image, micro_address_i <= last_q)
endmodule
