// SPDX-License-Identifier: MIT
#include "tests/rtl/icarus.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "tests/support/scratch.hpp"

namespace cigsim::test {
namespace {

unsigned bits_of(const std::vector<IcarusPort>& ports) {
  unsigned bits = 0;
  for (const IcarusPort& port : ports) bits += port.bits;
  return bits;
}

/// Connections of ports to the bits of a vector, the first port highest.
std::string connections(const std::vector<IcarusPort>& ports, const std::string& vector) {
  std::string text;
  unsigned above = bits_of(ports);
  for (const IcarusPort& port : ports) {
    text += ", ." + port.name + "(" + vector + "[" + std::to_string(above - 1) + ":" +
            std::to_string(above - port.bits) + "])";
    above -= port.bits;
  }
  return text;
}

std::string bench(const IcarusModule& module, std::size_t rows, const std::string& inputs) {
  std::string parameters;
  for (const std::string& p : module.parameters)
    parameters += (parameters.empty() ? " #(." : ", .") + p;
  if (!parameters.empty()) parameters += ")";
  const std::string last = std::to_string(rows - 1);
  return "module bench;\n  logic clk = 0;\n  logic [" + std::to_string(bits_of(module.inputs) - 1) +
         ":0] in, rows[0:" + last + "];\n  logic [" + std::to_string(bits_of(module.outputs) - 1) +
         ":0] out;\n  " + module.name + parameters + " module_under_test(.clk_i(clk)" +
         connections(module.inputs, "in") + connections(module.outputs, "out") +
         ");\n  initial begin\n    $readmemb(\"" + inputs +
         "\", rows);\n    for (int i = 0; i <= " + last +
         "; i++) begin\n      in = rows[i]; #1; $display(\"%b\", out);\n" +
         "      clk = 1; #1; clk = 0; #1;\n    end\n  end\nendmodule\n";
}

std::string binary(std::uint64_t value, unsigned bits) {
  std::string text;
  for (unsigned bit = bits; bit-- > 0;) text += value >> bit & 1 ? '1' : '0';
  return text;
}

void run(const std::string& command, const std::filesystem::path& log) {
  if (std::system((command + " 2>" + log.string()).c_str()) != 0)
    throw std::runtime_error(command + ": " + bytes_of(log));
}

}  // namespace

bool has_icarus() { return *CIGSIM_IVERILOG != '\0'; }

std::vector<std::vector<std::optional<std::uint64_t>>> run_icarus(
    const IcarusModule& module, const std::vector<std::vector<std::uint64_t>>& rows) {
  const Scratch scratch;
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += binary(row[i], module.inputs[i].bits);
    text += '\n';
  }
  const std::string inputs = scratch.write("inputs", text).string();
  std::string command = std::string(CIGSIM_IVERILOG) + " -g2012 -I" + CIGSIM_SOURCE_DIR +
                        " -s bench -o " + scratch.path("program").string() + " " +
                        scratch.write("bench.sv", bench(module, rows.size(), inputs)).string();
  for (const std::string& file : module.files) command += " " CIGSIM_SOURCE_DIR "/rtl/" + file;
  run(command, scratch.path("log"));
  run(std::string(CIGSIM_VVP) + " -n " + scratch.path("program").string() + " >" +
          scratch.path("outputs").string(),
      scratch.path("log"));

  std::vector<std::vector<std::optional<std::uint64_t>>> results;
  std::ifstream outputs(scratch.path("outputs"));
  const unsigned bits = bits_of(module.outputs);
  for (std::string line; std::getline(outputs, line);) {
    if (line.size() != bits || line.find_first_not_of("01xz") != std::string::npos) continue;
    auto& row = results.emplace_back();
    std::size_t at = 0;
    for (const IcarusPort& port : module.outputs) {
      const std::string value = line.substr(at, port.bits);
      at += port.bits;
      row.push_back(value.find_first_of("xz") == std::string::npos
                        ? std::optional<std::uint64_t>(std::stoull(value, nullptr, 2))
                        : std::nullopt);
    }
  }
  if (results.size() != rows.size())
    throw std::runtime_error(module.name + ": " + std::to_string(results.size()) + " rows of " +
                             std::to_string(rows.size()) + " came out of Icarus");
  return results;
}

}  // namespace cigsim::test
