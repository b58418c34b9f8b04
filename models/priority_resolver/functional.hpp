// SPDX-License-Identifier: MIT
// Priority resolver, functional level (Stump 1986, ch. II): a left edge enters its face in the list
// of active faces, a right edge takes it out; the active face of highest priority is shown.
#pragma once

#include <span>

#include "models/edge_orderer/functional.hpp"
#include "models/priority_resolver/active_list.hpp"
#include "models/priority_resolver/spans.hpp"

namespace cigsim::priority_resolver {

class Functional {
 public:
  /// Faces must be numbered in the order of their priority, highest first. Returns the number of
  /// spans that show a face.
  std::uint64_t compute(const edge_orderer::OrderedCrossings& ordered, std::size_t faces,
                        const Raster& raster, SpanLines& out) {
    out.reset(raster.height);
    std::uint64_t shown = 0;
    active_.grow(faces);
    for (int r = 0; r < raster.height; ++r) {
      const std::uint32_t first = ordered.first[r], count = ordered.first[r + 1] - first;
      const std::uint16_t width = static_cast<std::uint16_t>(raster.width);
      line({ordered.crossings.data() + first, count}, width, ordered.limit[r],
           [&](const Span& span) {
             out.add(r, span);
             shown += span.face != kNone;
           });
    }
    return shown;
  }

  /// The spans of one line from left to right, each handed to show(Span); they cover the elements
  /// 0..width once and none is empty. `crossings` are in the order of OrderedCrossings; from
  /// element `limit` on, 0..width, the line was cut and shows the background (`width`: not cut).
  template <class Show>
  void line(std::span<const Crossing> crossings, std::uint16_t width, std::uint16_t limit,
            Show show) {
    std::uint16_t start = 0;
    std::uint32_t top = kNone;
    const auto change = [&](std::uint16_t element, std::uint32_t face) {
      if (face == top) return;
      if (start < element) show(Span{top, start, element});
      start = element;
      top = face;
    };
    for (std::size_t c = 0; c < crossings.size() && crossings[c].element < limit;) {
      const std::uint16_t element = crossings[c].element;
      for (; c < crossings.size() && crossings[c].element == element; ++c) {
        active_.grow(crossings[c].face + std::size_t{1});
        active_.pass(crossings[c].face, crossings[c].left);
      }
      change(element, active_.first());
    }
    if (limit < width) change(limit, kNone);
    show(Span{top, start, width});
    active_.clear();
  }

 private:
  ActiveList active_;
};

}  // namespace cigsim::priority_resolver
