// SPDX-License-Identifier: MIT
#include "firmware/programs.hpp"

#include <stdexcept>

#include "firmware/embedded.hpp"

namespace cigsim::firmware {
namespace {

const EmbeddedProgram& embedded(std::string_view stage) {
  std::string known;
  for (const EmbeddedProgram& program : embedded_programs()) {
    if (program.stage == stage) return program;
    if (!known.empty()) known += ", ";
    known += program.stage;
  }
  throw std::invalid_argument("stage '" + std::string(stage) + "' is not microcoded; choose from " +
                              known);
}

}  // namespace

std::vector<std::string> microcoded_stages() {
  std::vector<std::string> stages;
  for (const EmbeddedProgram& program : embedded_programs()) stages.emplace_back(program.stage);
  return stages;
}

Format stage_format(std::string_view stage) {
  return parse_format("firmware/" + std::string(stage) + "/format.fmt", embedded(stage).format);
}

Program stage_program(std::string_view stage, const Overrides& overrides) {
  return assemble(stage_format(stage), "firmware/" + std::string(stage) + "/microprogram.mas",
                  embedded(stage).program, overrides);
}

}  // namespace cigsim::firmware
