// SPDX-License-Identifier: MIT
// The priority processor's memories, as words of 32 bits with addresses: the database's separation
// planes and pairs, and the two banks that the frame calculator leaves it (docs/machine/
// priority_processor.md, "Registers and memories"; the layout is a reconstruction). The
// microprogram reads nothing else.
//
// Database memory. A group's record, its planes and its members follow each other:
//   +0  address of its member words      +1  number of planes P, then P planes:
//       +0..2  unit normal, 1.30         +3, +4  distance, low and high half
//       +5     number of pairs less one  +6..    a pair a word: TRUE member in bits 0..5, FALSE
//                                                member in bits 8..13
//   then the member words: an item's number, or kGroupBit for a group.
//
// Bank.
//   0..2  eyepoint    3  address of the directory    4  number of ground items
//   5  address of the root's record, 0: nothing in view
//   6  with nothing in view: address of a list of all moving pieces, 0: there are none
//   8..   directory: for each static item 0, or the address of the list that stands for it
//   then a record of four words an active group, and the lists.
//   Record: +0 the group's record in the database memory; +1, +2 active members, low and high half;
//           +3 record of the first active group below it, the others follow in member order.
//   List: item words, the last with kLastBit; moving pieces have kMovingBit.
#pragma once

#include <cstdint>
#include <vector>

#include "models/boundary/words.hpp"
#include "models/machine/description.hpp"

namespace cigsim::priority_processor {

inline constexpr std::uint32_t kGroupBit = 0x8000'0000;   ///< of a member word
inline constexpr std::uint32_t kLastBit = 0x8000'0000;    ///< of a word in a list
inline constexpr std::uint32_t kMovingBit = 0x4000'0000;  ///< of a word in a list
inline constexpr std::uint32_t kItemMask = 0x3fff'ffff;

inline constexpr std::uint32_t kRecordWords = 4;   ///< of an active group
inline constexpr std::uint32_t kMostPairs = 4096;  ///< of a plane: the sequencer counts 12 bits

/// Places in a bank.
enum BankAddress : std::uint32_t {
  kEyeAt = 0,
  kDirectoryAt = 3,
  kGroundAt = 4,
  kRootAt = 5,
  kPiecesAt = 6,
  kDirectoryBegin = 8
};

/// A separation plane in machine words: N·R − d >= 0 on its TRUE side.
struct PlaneWords {
  Word normal[3] = {};       ///< 1.30
  Accumulator distance = 0;  ///< scaled as coordinates, 30 fraction bits more
};

/// `scale`: coordinate_scale() of the database. The distance is exact for the rounded normal and
/// the plane's point, rounded to nearest, and saturates at +-2^62.
PlaneWords plane_words(const Plane& plane, int scale, const WordFormats& formats);

/// The database memory.
struct PriorityMemory {
  std::vector<std::uint32_t> words;
  std::vector<std::uint32_t> group_address;  ///< by group of the hierarchy
  std::uint32_t items = 0;                   ///< static ones
  std::uint32_t depth = 0;                   ///< levels of groups

  /// Throws std::invalid_argument with a clear sentence when the hierarchy is deeper than the
  /// machine's (hierarchy_depth), or a plane has more than kMostPairs pairs.
  PriorityMemory(const PriorityHierarchy& hierarchy, std::size_t items, int scale,
                 const MachineDescription& machine);
};

/// One of the two banks. Frames are filled in anew; `memory` must outlive it.
class PriorityBank {
 public:
  explicit PriorityBank(const PriorityMemory& memory);

  /// What the frame calculator leaves for a frame. `active` must be of the memory's hierarchy, its
  /// moving pieces in the order that the frame calculator gives them.
  void fill(const ActiveEnvironment& active, const ViewWords& view, std::uint32_t ground_items);

  const PriorityMemory& memory() const { return *memory_; }
  const std::vector<std::uint32_t>& words() const { return words_; }
  std::uint32_t at(std::uint32_t address) const { return words_[address]; }
  std::uint32_t first_record() const { return kDirectoryBegin + memory_->items; }

 private:
  void add_lists(const ActiveEnvironment& active);

  const PriorityMemory* memory_;
  std::vector<std::uint32_t> words_;
  std::vector<std::uint32_t> listed_;  ///< items whose place in the directory is not 0
};

}  // namespace cigsim::priority_processor
