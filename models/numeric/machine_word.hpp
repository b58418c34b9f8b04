// SPDX-License-Identifier: MIT
// The machine's numbers: two's complement integers with a binary point. Formats are written
// "integer.fraction" bits with the sign apart, as in 13.18. A result too large for its word takes
// the nearest value that fits (saturation), and the overflow is counted. All widths are
// reconstruction: no source gives them (docs/machine.md, chapter "Machine words").
//
// The containers are fixed and the machine description says how many of their bits a machine has:
// fewer fraction bits leave the low bits of a container zero.
#pragma once

#include <cstdint>

namespace cigsim {

using Word = std::int32_t;
using Accumulator = std::int64_t;

/// Fraction bits of the containers.
inline constexpr int kDirectionFraction = 30;  ///< 1.30: unit normals, the view matrix
inline constexpr int kQuotientFraction = 30;   ///< 1.30: results of the divider, in -1..1
inline constexpr int kRasterFraction = 18;     ///< 13.18: raster columns, lines and slopes

/// How many bits a machine has (machine description, "formats").
struct WordFormats {
  int coordinate_bits = 31;     ///< coordinates, sign included, 16..31; differences have one more
  int direction_fraction = 30;  ///< 12..30
  int quotient_fraction = 24;   ///< 8..30, even: the divider yields two bits a cycle
  int raster_fraction = 18;     ///< 4..18
  friend bool operator==(const WordFormats&, const WordFormats&) = default;
};

/// A raster quantity in 13.18.
struct MachineWord {
  Word raw = 0;
  friend bool operator==(const MachineWord&, const MachineWord&) = default;
};

inline double to_double(MachineWord value) {
  return value.raw / static_cast<double>(1 << kRasterFraction);
}

/// The nearest value of a signed word of `bits` bits (sign included, 2..63).
inline Accumulator saturate(Accumulator value, int bits, std::uint64_t& overflows) {
  const Accumulator limit = Accumulator{1} << (bits - 1);
  if (value >= limit) {
    ++overflows;
    return limit - 1;
  }
  if (value < -limit) {
    ++overflows;
    return -limit;
  }
  return value;
}

/// value / 2^shift, rounded to nearest, halves towards plus infinity.
inline Accumulator round_shift(Accumulator value, int shift) {
  return shift == 0 ? value : (value + (Accumulator{1} << (shift - 1))) >> shift;
}

}  // namespace cigsim
