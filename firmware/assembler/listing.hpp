// SPDX-License-Identifier: MIT
// Microprograms as text (docs/machine/microprograms.md, "How to read a listing").
#pragma once

#include <string>

#include "firmware/assembler/program.hpp"

namespace cigsim::firmware {

/// The format's fields; then, a line an instruction: address, word in hex, label, source; then
/// constants and costs.
std::string listing(const Program& program);

/// One word a line in hex, width/4 digits rounded up, as Verilog's $readmemh reads it.
std::string hex_image(const Program& program);

}  // namespace cigsim::firmware
