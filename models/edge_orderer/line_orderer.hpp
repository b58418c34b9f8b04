// SPDX-License-Identifier: MIT
// Machine words: the crossings of one line after the other, in their order, and what becomes of a
// line with too many (docs/machine/edge_orderer.md, EO1 to EO4). The functional and the timed level
// compute with it.
//
// The edges on the active list are kept in the order of their crossings: from line to line it
// changes little, so that inserting each into those before it costs next to nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/edge_orderer/edge_bank.hpp"
#include "models/edge_orderer/figures.hpp"
#include "models/machine/description.hpp"

namespace cigsim::edge_orderer {

/// Limits of the order's key (EO3): element, kind, face and place in one word.
inline constexpr int kFaceBits = 24, kPlaceBits = 25;

/// An edge with its crossing of the line in work.
struct ActiveEdge {
  std::uint64_t key = 0;  ///< orders crossings: element, left, face, place in the edge memory
  Word x = 0, slope = 0;
  std::uint32_t end_line = 0;

  std::uint16_t element() const {
    return static_cast<std::uint16_t>(key >> (1 + kFaceBits + kPlaceBits));
  }
  bool left() const { return (key >> (kFaceBits + kPlaceBits)) & 1; }
  std::uint32_t face() const {
    return static_cast<std::uint32_t>(key >> kPlaceBits) & ((1u << kFaceBits) - 1);
  }
};

/// A line's crossings in order, before overload, and what overload does to them.
struct OrderedLine {
  std::span<const ActiveEdge> crossings;
  std::uint32_t count = 0;           ///< of the first so many ...
  std::uint32_t face_limit = kNone;  ///< ... those of faces below this one are kept
  bool cut = false;
  std::uint16_t cut_element = 0;  ///< when cut: that of the first crossing not kept

  /// Hands the crossings that are kept to use(ActiveEdge), in order.
  template <class Use>
  void for_each_kept(Use use) const {
    for (const ActiveEdge& edge : crossings.first(count))
      if (edge.face() < face_limit) use(edge);
  }
};

class LineOrderer {
 public:
  /// `width`: 1..8191 elements. `capacity`: crossings of a line, 0: no limit.
  LineOrderer(int width, std::uint32_t capacity, OverloadPolicy policy)
      : width_(width), capacity_(capacity), policy_(policy) {}

  /// Begins a picture. `bank` must stay until its last line was ordered; its buckets are emptied.
  void begin(EdgeBank& bank);
  /// The next line of the picture, from line 0 on. It is valid until the next call.
  const OrderedLine& next();
  /// Of the picture so far. Frame number and activity are the caller's.
  const Figures& figures() const { return figures_; }

 private:
  void step_active();
  void enter_new();
  void limit_line();
  std::uint64_t element_key(Word x) const;

  int width_;
  std::uint32_t capacity_;
  OverloadPolicy policy_;
  EdgeBank* bank_ = nullptr;
  std::uint32_t line_ = 0;
  std::vector<ActiveEdge> active_, new_;
  std::vector<std::uint32_t> faces_;
  OrderedLine ordered_;
  Figures figures_;
};

}  // namespace cigsim::edge_orderer
