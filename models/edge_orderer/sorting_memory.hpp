// SPDX-License-Identifier: MIT
// Edge orderer, clocked level: a sorting memory, the cells that hold a line's crossings in their
// order (docs/machine/edge_orderer.md, EO3 and EO4). Reconstruction.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "models/boundary/words.hpp"
#include "models/machine/description.hpp"

namespace cigsim::edge_orderer {

class SortingMemory {
 public:
  struct Cell {
    std::uint16_t element = 0;
    bool left = false;
    std::uint32_t face = 0, place = 0;
    friend auto operator<=>(const Cell&, const Cell&) = default;
  };
  /// Registers that the passes of a line share.
  struct LineRegisters {
    std::uint32_t limit = kNone;  ///< kDrop: faces from this one on are dropped
    bool cut = false;             ///< kCut: rest is valid
    Cell rest;                    ///< the first crossing that was pushed out
    bool marked = false;          ///< kExtend: mark is valid
    Cell mark;                    ///< the last crossing of the pass before
  };

  SortingMemory(std::uint32_t capacity, OverloadPolicy policy)
      : capacity_(capacity), policy_(policy) {}

  /// One cycle of filling: returns how many crossings were dropped for good by it.
  std::uint32_t insert(const Cell& cell, LineRegisters& line);
  /// The pass is filled; `line_end`: the line's end word follows its crossings.
  void close(bool line_end, LineRegisters& line);

  /// Filled and not yet drained.
  bool filled() const { return filled_; }
  /// The word that is offered while it drains.
  CrossingWord front() const;
  /// That word was taken. Returns whether it was the last.
  bool shift();
  bool ends_line() const { return end_.end; }
  /// Crossings in the cells (for waves).
  const std::uint32_t& held() const { return held_; }

 private:
  void place(const Cell& cell);
  std::uint32_t clear_from_highest_face(const Cell& cell, LineRegisters& line);

  std::uint32_t capacity_;
  OverloadPolicy policy_;
  std::vector<Cell> cells_;  // ascending
  std::size_t first_ = 0;    // those before were shifted out
  bool filled_ = false;
  CrossingWord end_;  // `end` is not set in a pass that another one of the line follows
  std::uint32_t held_ = 0;
};

}  // namespace cigsim::edge_orderer
