// SPDX-License-Identifier: MIT
#include "sim/cosim/report.hpp"

#include <fmt/format.h>

namespace cigsim::cosim {

std::vector<std::string> mismatch_lines(const Mismatch& m) {
  std::vector<std::string> lines{
      fmt::format("Mismatch  {}, frame {}{}, cycle {}: {}", m.stage, m.frame,
                  m.line ? fmt::format(", line {}", *m.line) : "", m.cycle, m.field),
      fmt::format("Expected  {}", m.expected), fmt::format("Got       {}", m.got)};
  for (const std::string& input : m.inputs)
    lines.push_back(
        fmt::format("{}{}", &input == &m.inputs.front() ? "Inputs    " : "          ", input));
  return lines;
}

std::string summary(const SoMismatch& m) {
  return fmt::format("so_engine, vector {}, cycle {}, row {}: {} expected {}, got {}", m.vector,
                     m.cycle, m.row, m.field, m.expected, m.got);
}

std::vector<std::string> mismatch_lines(const SoMismatch& m) {
  return {fmt::format("Mismatch  so_engine, vector {}, cycle {}, row {}: {}", m.vector, m.cycle,
                      m.row, m.field),
          fmt::format("Expected  {}", m.expected), fmt::format("Got       {}", m.got)};
}

nlohmann::ordered_json mismatch_json(const Mismatch& m) {
  nlohmann::ordered_json json{
      {"stage", m.stage}, {"field", m.field}, {"cycle", m.cycle}, {"frame", m.frame}};
  if (m.line) json["line"] = *m.line;
  json["expected"] = m.expected;
  json["got"] = m.got;
  json["inputs"] = m.inputs;
  return json;
}

}  // namespace cigsim::cosim
