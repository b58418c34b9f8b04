// SPDX-License-Identifier: MIT
// The format of a processor's microinstructions: named fields of one wide word, declared once in a
// file (docs/machine/microprograms.md, "Format files"). The assembler, the clocked level and the
// listing all take it from there.
//
//   format NAME
//   sequencer                 ; the fields of every processor: op, pol, d, address
//   field cond 4              ; NAME BITS [default VALUE]; then its values, one a line
//     TRUE    0
//     START   1
//   field count 6 default 0
//
// Fields lie side by side in the order of their declarations, the first at bit 0; one that would
// lie across bit 64 begins at bit 64. Comments begin with ';'.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cigsim::firmware {

inline constexpr unsigned kWordBits = 128;

/// A microinstruction: bits 0..63 and 64..127.
struct Microword {
  std::uint64_t low = 0, high = 0;
  friend bool operator==(const Microword&, const Microword&) = default;
};

/// Where a field lies; decodes in two operations.
struct FieldPlace {
  unsigned first = 0;  ///< bit 0..127
  unsigned bits = 1;   ///< 1..32

  std::uint32_t get(const Microword& word) const {
    const std::uint64_t half = first < 64 ? word.low : word.high;
    return static_cast<std::uint32_t>(half >> (first & 63) & mask());
  }
  void set(Microword& word, std::uint32_t value) const {
    std::uint64_t& half = first < 64 ? word.low : word.high;
    half = (half & ~(mask() << (first & 63))) | (value & mask()) << (first & 63);
  }
  std::uint64_t mask() const { return (std::uint64_t{1} << bits) - 1; }
};

struct Field {
  std::string name;
  FieldPlace place;
  std::map<std::string, std::uint32_t, std::less<>> values;  ///< the named ones
  std::uint32_t fallback = 0;                                ///< where a line does not set it
};

struct Format {
  std::string name;
  unsigned width = 0;  ///< bits, at most kWordBits
  std::vector<Field> fields;

  /// nullptr when there is no such field.
  const Field* find(std::string_view field) const;
  /// Throws std::invalid_argument when there is no such field.
  const Field& field(std::string_view field) const;
  FieldPlace place(std::string_view name) const { return field(name).place; }
  /// The code of a named value, for decoders. Throws std::invalid_argument when there is none.
  std::uint32_t value(std::string_view field, std::string_view value) const;
};

/// Reads a format file; `file` is its name in messages. Throws InputError (file, line, what and
/// what to do).
Format parse_format(const std::string& file, std::string_view text);

}  // namespace cigsim::firmware
