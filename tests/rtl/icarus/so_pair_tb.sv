// SPDX-License-Identifier: MIT
// Puts four words of a line of stimulus on so_pair, and writes its three answers, for each line:
//   vvp so_pair_tb.vvp +stimulus=FILE +outputs=FILE
module so_pair_tb;
  logic [63:0] s_l, r_l, s_m, r_m;
  logic hides, hidden, unresolved;
  so_pair #(
      .Planes(64)
  ) u_pair (
      .s_l_i       (s_l),
      .r_l_i       (r_l),
      .s_m_i       (s_m),
      .r_m_i       (r_m),
      .hides_o     (hides),
      .hidden_o    (hidden),
      .unresolved_o(unresolved)
  );

  integer stimulus, outputs;
  logic [1023:0] name;
  initial begin
    if ($value$plusargs("stimulus=%s", name) == 0) $finish;
    stimulus = $fopen(name, "r");
    if ($value$plusargs("outputs=%s", name) == 0) $finish;
    outputs = $fopen(name, "w");
    while ($fscanf(stimulus, "%h %h %h %h", s_l, r_l, s_m, r_m) == 4) begin
      #1 $fdisplay(outputs, "%b%b%b", hides, hidden, unresolved);
    end
    $fclose(outputs);
    $finish;
  end
endmodule
