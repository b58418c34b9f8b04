// SPDX-License-Identifier: MIT
// The vectors of sim/cosim/so_vectors.hpp as text, for so_engine_tb.sv.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "rtl/priority_processor/so_engine.pins.hpp"
#include "sim/cosim/so_vectors.hpp"

namespace cigsim {

/// `bits` bits as Verilog's %h writes them.
inline std::string verilog_hex(const std::uint32_t* words, unsigned bits) {
  std::string digits;
  for (unsigned nibble = (bits + 3) / 4; nibble-- > 0;)
    digits += "0123456789abcdef"[words[nibble / 8] >> nibble % 8 * 4 & 15];
  return digits;
}

/// Has `options` write a line of inputs, and the line of outputs that has to come, each cycle.
inline void write_cycles(cosim::SoVectorOptions& options, std::ostream& stimulus,
                         std::ostream& outputs) {
  const unsigned objects = options.objects, planes = options.planes;
  const auto index_width = static_cast<unsigned>(std::bit_width(objects - 1));
  options.each_cycle = [=, &stimulus, &outputs](const RtlModel& model, std::uint64_t) {
    const auto& pins = model.pins<rtl::so_engine::Pins>();
    stimulus << fmt::format(
        "{:d} {} {} {} {:d} {} {}\n", pins.row_valid_i, verilog_hex(&pins.row_index_i, index_width),
        verilog_hex(pins.row_tells_i, planes), verilog_hex(pins.row_plus_i, planes),
        pins.start_valid_i, verilog_hex(pins.start_eye_i, planes),
        verilog_hex(pins.start_active_i, objects));
    outputs << fmt::format(
        "{:d} {:d} {} {} {} {} {} {:d} {:d} {:d}\n", pins.start_ready_o, pins.answer_valid_o,
        verilog_hex(&pins.answer_row_o, index_width), verilog_hex(pins.answer_hides_o, objects),
        verilog_hex(pins.answer_hidden_o, objects), verilog_hex(pins.answer_unresolved_o, objects),
        verilog_hex(&pins.answer_count_o, index_width), pins.answer_last_o, pins.answer_unique_o,
        pins.answer_resolved_o);
  };
}

/// Builds `bench` (of this folder) with Icarus. `parameters`, such as "-Pso_engine_tb.Planes=16".
/// Throws std::runtime_error when it does not build.
inline void build_with_icarus(const std::filesystem::path& sources, const std::string& bench,
                              const std::string& parameters, const std::filesystem::path& program) {
  const std::string command = fmt::format(
      "iverilog -g2012 {2} -I'{0}' -y'{0}/rtl/common' -y'{0}/rtl/priority_processor' -Y.sv "
      "-s {1} -o '{3}' '{0}/tests/rtl/icarus/{1}.sv'",
      sources.string(), bench, parameters, program.string());
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

/// Throws std::runtime_error when it fails.
inline void run_with_icarus(const std::filesystem::path& program,
                            const std::filesystem::path& stimulus,
                            const std::filesystem::path& outputs) {
  const std::string command = fmt::format("vvp '{}' '+stimulus={}' '+outputs={}' >/dev/null",
                                          program.string(), stimulus.string(), outputs.string());
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

}  // namespace cigsim
