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

/// The inside state of each face, -1, 0 or +1, in two bits; a face is active while it is +1. Right
/// edges come first at an element, so a face whose two edges cross there passes through -1 and is
/// never active. States beyond do not exist: a further left edge leaves +1, a further right edge
/// -1.
class ActiveList {
 public:
  /// Room for so many faces; never less than before.
  void grow(std::size_t faces) {
    if (faces <= size_) return;
    words_.resize((faces + 63) / 64);
    summary_.resize((words_.size() + 63) / 64, 0);
    size_ = words_.size() * 64;
  }
  /// Faces that there is room for.
  std::size_t size() const { return size_; }

  /// A crossing of `face`, for which there must be room.
  void pass(std::uint32_t face, bool left) {
    const std::uint32_t w = face / 64;
    Word word = words_[w];
    const std::uint64_t bit = std::uint64_t{1} << (face % 64);
    const std::uint64_t to = left ? bit : 0, from = bit ^ to;
    const std::uint64_t active = (word.active | (to & ~word.passed)) & ~from;
    const std::uint64_t passed = (word.passed | (from & ~word.active)) & ~to;
    const auto change = [bit](std::uint64_t after, std::uint64_t before) {
      return static_cast<int>((after & bit) != 0) - static_cast<int>((before & bit) != 0);
    };
    count_ += change(active, word.active);
    open_ += change(active | passed, word.active | word.passed);
    words_[w] = {active, passed};
    std::uint64_t& summary = summary_[w / 64];
    summary = (summary & ~(std::uint64_t{1} << (w % 64))) | std::uint64_t{active != 0} << (w % 64);
    assert(left || !(active & bit));
  }
  /// The active face of highest priority, or kNone.
  std::uint32_t first() const {
    for (std::size_t s = 0; s < summary_.size(); ++s) {
      if (summary_[s] == 0) continue;
      const std::size_t w = s * 64 + static_cast<std::size_t>(std::countr_zero(summary_[s]));
      return static_cast<std::uint32_t>(
          w * 64 + static_cast<std::size_t>(std::countr_zero(words_[w].active)));
    }
    return kNone;
  }
  /// How many faces are active.
  int count() const { return count_; }
  /// The line's end: every inside state is 0.
  void clear() {
    if (open_ == 0) return;
    std::fill(words_.begin(), words_.end(), Word{});
    std::fill(summary_.begin(), summary_.end(), 0);
    count_ = open_ = 0;
  }

 private:
  /// The states of 64 faces, highest priority in the lowest bit: +1, and -1.
  struct Word {
    std::uint64_t active = 0, passed = 0;
  };
  std::vector<Word> words_;
  std::vector<std::uint64_t> summary_;  ///< a bit a word that has an active face
  std::size_t size_ = 0;
  int count_ = 0;
  int open_ = 0;  ///< faces whose inside state is not 0
};

}  // namespace cigsim::priority_resolver
