// SPDX-License-Identifier: MIT
// The list of active faces (Stump 1986, ch. II): a left edge enters its face, a right edge takes it
// out. The bits, their encoder and the two-bit inside state are reconstruction
// (docs/machine/priority_resolver.md, PR1).
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "models/database/database.hpp"

namespace cigsim::priority_resolver {

/// A bit a face, highest priority first, with a summary word for each 64 words of them.
class ActiveFaces {
 public:
  void resize(std::size_t faces) {
    words_.resize((faces + 63) / 64, 0);
    summary_.resize((words_.size() + 63) / 64, 0);
  }
  void clear() {
    std::fill(words_.begin(), words_.end(), 0);
    std::fill(summary_.begin(), summary_.end(), 0);
  }
  void set(std::uint32_t face, bool active) {
    std::uint64_t& word = words_[face / 64];
    word = (word & ~(std::uint64_t{1} << (face % 64))) | std::uint64_t{active} << (face % 64);
    const std::uint32_t w = face / 64;
    std::uint64_t& summary = summary_[w / 64];
    summary = (summary & ~(std::uint64_t{1} << (w % 64))) | std::uint64_t{word != 0} << (w % 64);
  }
  bool has(std::uint32_t face) const { return words_[face / 64] >> (face % 64) & 1; }
  /// The active face of highest priority, or kNone.
  std::uint32_t first() const {
    for (std::size_t s = 0; s < summary_.size(); ++s) {
      if (summary_[s] == 0) continue;
      const std::size_t w = s * 64 + static_cast<std::size_t>(std::countr_zero(summary_[s]));
      return static_cast<std::uint32_t>(w * 64 +
                                        static_cast<std::size_t>(std::countr_zero(words_[w])));
    }
    return kNone;
  }

 private:
  std::vector<std::uint64_t> words_, summary_;
};

/// The active faces with the inside state of each face: -1, 0 or +1. Right edges come first at an
/// element, so a face whose two edges cross there passes through -1 and is never active. States
/// beyond do not exist: a further left edge leaves +1, a further right edge -1.
class ActiveList {
 public:
  /// Room for so many faces; never less than before.
  void grow(std::size_t faces) {
    if (faces <= inside_.size()) return;
    inside_.resize(faces, 0);
    active_.resize(faces);
  }
  /// A crossing of `face`, for which there must be room.
  void pass(std::uint32_t face, bool left) {
    const int before = inside_[face];
    const int after = std::clamp(before + (left ? 1 : -1), -1, 1);
    inside_[face] = static_cast<std::int8_t>(after);
    active_.set(face, after > 0);
    assert(left || !active_.has(face));
    count_ += (after > 0) - (before > 0);
    open_ += (after != 0) - (before != 0);
  }
  /// The active face of highest priority, or kNone.
  std::uint32_t first() const { return active_.first(); }
  /// How many faces are active.
  int count() const { return count_; }
  /// The line's end: no face is active and every inside state is 0.
  void clear() {
    if (open_ == 0) return;
    std::fill(inside_.begin(), inside_.end(), 0);
    active_.clear();
    count_ = open_ = 0;
  }
  std::size_t size() const { return inside_.size(); }

 private:
  ActiveFaces active_;
  std::vector<std::int8_t> inside_;
  int count_ = 0;
  int open_ = 0;  // faces whose inside state is not 0
};

}  // namespace cigsim::priority_resolver
