// SPDX-License-Identifier: MIT
// A microprogram: the source assembled to words, with its labels, constants and costs
// (docs/machine/microprograms.md, "Assembler" and "Costs").
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/assembler/format.hpp"
#include "models/boundary/cycle.hpp"

namespace cigsim::firmware {

struct Program {
  std::string name;  ///< of the source
  Format format;
  std::vector<Microword> words;  ///< from address 0 on, at most 4,096

  struct Source {
    int line = 0;
    std::string text;
  };
  std::vector<Source> sources;  ///< one a word

  std::map<std::string, std::uint32_t, std::less<>> labels;
  std::map<std::string, std::int64_t, std::less<>> constants;  ///< after overrides
  std::map<std::string, Cycle, std::less<>> costs;

  /// Cycles of a path that the source names with .cost. Throws std::invalid_argument when it does
  /// not.
  Cycle cost(std::string_view path) const;
  /// The address of a label. Throws std::invalid_argument when there is none.
  std::uint32_t address(std::string_view label) const;
};

/// Constants of the source that the machine description sets anew.
using Overrides = std::map<std::string, std::int64_t, std::less<>>;

/// Assembles. The language, a line an instruction:
///
///   .define NAME EXPRESSION          a constant; `overrides` may give it another value
///   .cost NAME FROM TO [pass LABEL…] [fail LABEL…]
///   LABEL: field=VALUE field=VALUE OP [ADDRESS] [if COND | unless COND]   ; comment
///
/// Settings are separated by spaces or commas. OP is an instruction of the sequencer (CJP, RPCT, …)
/// and short for op=OP; the word after it for address=…; `if C` for cond=C pol=0, `unless C` for
/// cond=C pol=1. `nop` stands for no setting. A VALUE is one of the field's own names or an
/// EXPRESSION of numbers (also 0x…), constants, labels and `.` (this address) with + - * /.
///
/// .cost counts the cycles of the path from FROM up to TO, not counting TO itself: subroutines and
/// loops of a known count are followed. The path may not depend on data, except at instructions
/// that stand after `pass` or `fail` by a label of theirs, which are taken to go that way each
/// time (a counted loop of unknown count: pass goes round again, fail leaves).
///
/// Throws InputError (file, line, what and what to do), also for an override that the source does
/// not define.
Program assemble(const Format& format, const std::string& source_file, std::string_view text,
                 const Overrides& overrides = {});

}  // namespace cigsim::firmware
