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

/// One address a line: the address, and the last label up to there, with how far it is beyond it:
/// a filter file of GTKWave that shows a microaddress by name.
std::string address_names(const Program& program);

}  // namespace cigsim::firmware
