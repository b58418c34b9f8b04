// SPDX-License-Identifier: MIT
// The parts of about 1975 that RTL is mapped to: gates of the 74S family (Schottky TTL) in packages
// of 14 or 16 pins. How many are in a package is in the makers' data sheets. That the list stops
// here, and that a XOR and a multiplexer stand for two gate levels, is reconstruction.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cigsim::gates {

struct Part {
  std::string_view name;      ///< of the cell
  std::string_view function;  ///< of its output Y, in the GENLIB format of Berkeley's SIS and ABC
  std::string_view package;   ///< 74S type
  int per_package;
  int levels;
};

std::span<const Part> parts();
/// Null where there is none of that name.
const Part* find_part(std::string_view name);
/// The library for ABC: the area is a share of a package, the delay is in gate levels.
std::string genlib();

inline constexpr int kFlipFlopsPerPackage = 6;      ///< 74S174
inline constexpr int kRamWords = 16, kRamBits = 4;  ///< 74S189, of one read or write at a time

/// A logic family. The same network of gates is assumed in each.
struct Family {
  std::string_view name;
  double gate_ns, ram_ns;   ///< of a gate level; of reading a RAM of 16 x 4 bits
  std::string_view source;  ///< of these two, with their standing
};

std::span<const Family> families();

}  // namespace cigsim::gates
