// SPDX-License-Identifier: MIT
// The sources of the microprograms, which the build puts into the library (embed.cmake).
#pragma once

#include <span>
#include <string_view>

namespace cigsim::firmware {

struct EmbeddedProgram {
  std::string_view stage, format, program;
};

std::span<const EmbeddedProgram> embedded_programs();

}  // namespace cigsim::firmware
