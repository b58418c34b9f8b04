// SPDX-License-Identifier: MIT
#include "sim/gates/parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cigsim::gates {
namespace {

constexpr Part kParts[] = {
    {"INV", "!A", "74S04", 6, 1},
    {"NAND2", "!(A*B)", "74S00", 4, 1},
    {"NAND3", "!(A*B*C)", "74S10", 3, 1},
    {"NAND4", "!(A*B*C*D)", "74S20", 2, 1},
    {"AND2", "A*B", "74S08", 4, 1},
    {"AND3", "A*B*C", "74S11", 3, 1},
    {"OR2", "A+B", "74S32", 4, 1},
    {"NOR2", "!(A+B)", "74S02", 4, 1},
    {"NOR5", "!(A+B+C+D+E)", "74S260", 2, 1},
    {"AOI22", "!(A*B+C*D)", "74S51", 2, 1},
    {"XOR2", "A*!B+!A*B", "74S86", 4, 2},
    {"MUX2", "A*!S+B*S", "74S157", 4, 2},
};

constexpr Family kFamilies[] = {
    {"74S", 3, 35, "gate and RAM published (data sheets of the time)"},
    {"ECL 10K", 2, 10,
     "gate published (MECL 10,000, 10100 series; Maini, Digital Electronics, 5.4.1.2), RAM (10145) "
     "recalled"},
};

constexpr int kAreaOfPackage = 12;  // divisible by every number of parts in a package

}  // namespace

std::span<const Part> parts() { return kParts; }

const Part* find_part(std::string_view name) {
  const auto* found = std::ranges::find(kParts, name, &Part::name);
  return found == std::end(kParts) ? nullptr : found;
}

std::string genlib() {
  std::string text;
  for (const Part& part : kParts)
    text += fmt::format("GATE {} {} Y={}; PIN * UNKNOWN 1 999 {} 0 {} 0\n", part.name,
                        kAreaOfPackage / part.per_package, part.function, part.levels, part.levels);
  return text + "GATE ZERO 0 Y=CONST0;\nGATE ONE 0 Y=CONST1;\n";
}

std::span<const Family> families() { return kFamilies; }

}  // namespace cigsim::gates
