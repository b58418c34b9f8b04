// SPDX-License-Identifier: MIT
#include "firmware/programs.hpp"

#include <algorithm>
#include <stdexcept>

#include "firmware/embedded.hpp"

namespace cigsim::firmware {
namespace {

struct Source {
  std::string file;
  std::string_view text;
};

/// `file`: "format.fmt" or "microprogram.mas".
Source source(std::string_view stage, const std::string& file) {
  std::string known;
  for (const std::string& microcoded : microcoded_stages()) {
    const std::string path = microcoded + "/" + file;
    if (microcoded == stage) return {"firmware/" + path, embedded_text(embedded_firmware(), path)};
    known += (known.empty() ? "" : ", ") + microcoded;
  }
  throw std::invalid_argument("stage '" + std::string(stage) + "' is not microcoded; choose from " +
                              known);
}

}  // namespace

std::vector<std::string> microcoded_stages() {
  std::vector<std::string> stages;
  for (const EmbeddedFile& file : embedded_firmware()) {
    const std::string stage(file.path.substr(0, file.path.find('/')));
    if (std::find(stages.begin(), stages.end(), stage) == stages.end()) stages.push_back(stage);
  }
  return stages;
}

Format stage_format(std::string_view stage) {
  const Source format = source(stage, "format.fmt");
  return parse_format(format.file, format.text);
}

Program stage_program(std::string_view stage, const Overrides& overrides) {
  const Format format = stage_format(stage);
  const Source program = source(stage, "microprogram.mas");
  return assemble(format, program.file, program.text, overrides);
}

}  // namespace cigsim::firmware
