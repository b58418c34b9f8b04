// SPDX-License-Identifier: MIT
// Drives so_engine with a line of stimulus a cycle, and writes a line of outputs for each:
//   vvp so_engine_tb.vvp +stimulus=FILE +outputs=FILE
module so_engine_tb;
  parameter int Objects = 64;
  parameter int Planes = 64;
  localparam int IndexWidth = $clog2(Objects);

  logic clk, rst;
  logic row_valid, start_valid;
  logic [IndexWidth-1:0] row_index;
  logic [Planes-1:0] row_tells, row_plus, start_eye;
  logic [Objects-1:0] start_active;
  logic start_ready, answer_valid, answer_last, answer_unique, answer_resolved;
  logic [IndexWidth-1:0] answer_row, answer_count;
  logic [Objects-1:0] hides, hidden, unresolved;

  so_engine #(
      .Objects(Objects),
      .Planes (Planes)
  ) u_engine (
      .clk_i              (clk),
      .rst_i              (rst),
      .cfg_last_row_i     (IndexWidth'(Objects - 1)),
      .row_valid_i        (row_valid),
      .row_index_i        (row_index),
      .row_tells_i        (row_tells),
      .row_plus_i         (row_plus),
      .start_valid_i      (start_valid),
      .start_ready_o      (start_ready),
      .start_eye_i        (start_eye),
      .start_active_i     (start_active),
      .answer_valid_o     (answer_valid),
      .answer_row_o       (answer_row),
      .answer_hides_o     (hides),
      .answer_hidden_o    (hidden),
      .answer_unresolved_o(unresolved),
      .answer_count_o     (answer_count),
      .answer_last_o      (answer_last),
      .answer_unique_o    (answer_unique),
      .answer_resolved_o  (answer_resolved)
  );

  task automatic edge_of_clock;
    #1 clk = 1'b1;
    #1;
  endtask

  integer stimulus, outputs;
  logic [1023:0] name;
  initial begin
    if ($value$plusargs("stimulus=%s", name) == 0) $finish;
    stimulus = $fopen(name, "r");
    if ($value$plusargs("outputs=%s", name) == 0) $finish;
    outputs = $fopen(name, "w");
    clk = 1'b0;
    rst = 1'b1;
    row_valid = 1'b0;
    start_valid = 1'b0;
    edge_of_clock;
    clk = 1'b0;
    edge_of_clock;
    rst = 1'b0;
    while ($fscanf(stimulus, "%b %h %h %h %b %h %h", row_valid, row_index, row_tells, row_plus,
                   start_valid, start_eye, start_active) == 7) begin
      clk = 1'b0;
      edge_of_clock;
      $fdisplay(outputs, "%b %b %h %h %h %h %h %b %b %b", start_ready, answer_valid, answer_row,
                hides, hidden, unresolved, answer_count, answer_last, answer_unique,
                answer_resolved);
    end
    $fclose(outputs);
    $finish;
  end
endmodule
