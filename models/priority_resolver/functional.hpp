// SPDX-License-Identifier: MIT
// Priority resolver, functional level (Stump 1986, ch. II): a left edge enters its face in the list
// of active faces, a right edge takes it out; the active face of highest priority is shown.
#pragma once

#include <bit>

#include "models/edge_orderer/functional.hpp"
#include "models/priority_resolver/spans.hpp"

namespace cigsim::priority_resolver {

/// The active list: a bit a face, highest priority first, with a summary word for each 64.
class ActiveFaces {
 public:
  void reset(std::size_t faces) {
    words_.assign((faces + 63) / 64, 0);
    summary_.assign((words_.size() + 63) / 64, 0);
  }
  void enter(std::uint32_t face) {
    words_[face / 64] |= bit(face);
    summary_[face / 4096] |= bit(face / 64);
  }
  void leave(std::uint32_t face) {
    words_[face / 64] &= ~bit(face);
    if (words_[face / 64] == 0) summary_[face / 4096] &= ~bit(face / 64);
  }
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
  static std::uint64_t bit(std::uint32_t n) { return std::uint64_t{1} << (n % 64); }
  std::vector<std::uint64_t> words_, summary_;
};

class Functional {
 public:
  /// Faces must be numbered in the order of their priority, highest first. Returns the number of
  /// spans that show a face.
  std::uint64_t compute(const edge_orderer::OrderedCrossings& ordered, std::size_t faces,
                        const Raster& raster, SpanLines& out) {
    out.reset(raster.height);
    std::uint64_t shown = 0;
    active_.reset(faces);
    inside_.assign(faces, 0);
    for (int r = 0; r < raster.height; ++r) shown += line(ordered, r, raster.width, out);
    return shown;
  }

 private:
  std::uint64_t line(const edge_orderer::OrderedCrossings& ordered, int r, int width,
                     SpanLines& out) {
    std::uint64_t shown = 0;
    std::uint16_t start = 0;
    std::uint32_t top = kNone;
    const auto show = [&](std::uint16_t end) {
      if (end <= start) return;
      out.add(r, {top, start, end});
      shown += top != kNone;
      start = end;
    };
    const std::uint32_t end = ordered.first[r + 1];
    for (std::uint32_t c = ordered.first[r]; c < end;) {
      const std::uint16_t element = ordered.crossings[c].element;
      for (; c < end && ordered.crossings[c].element == element; ++c) pass(ordered.crossings[c]);
      const std::uint32_t now = active_.first();
      if (now == top) continue;
      show(element);
      top = now;
    }
    show(static_cast<std::uint16_t>(width));
    // A face without area on this line may have met its right edge first.
    for (std::uint32_t c = ordered.first[r]; c < end; ++c) {
      active_.leave(ordered.crossings[c].face);
      inside_[ordered.crossings[c].face] = 0;
    }
    return shown;
  }

  // Right edges come first at an element, so a face whose two edges cross there passes through
  // minus one and is never shown.
  void pass(const Crossing& crossing) {
    std::int8_t& inside = inside_[crossing.face];
    inside = static_cast<std::int8_t>(inside + (crossing.left ? 1 : -1));
    if (inside > 0)
      active_.enter(crossing.face);
    else
      active_.leave(crossing.face);
  }

  ActiveFaces active_;
  std::vector<std::int8_t> inside_;
};

}  // namespace cigsim::priority_resolver
