// SPDX-License-Identifier: MIT
// Assertion: the spans of a line cover it exactly once, from left to right, and none is empty.
#pragma once

#include <cassert>
#include <cstdint>

#include "models/boundary/words.hpp"

namespace cigsim::priority_resolver {

class SpanCheck {
 public:
  /// The next span of the lines of a raster that is `width` elements wide.
  void span([[maybe_unused]] const SpanWord& span, [[maybe_unused]] std::uint16_t width) {
    assert(span.first == covered_ && span.first < span.end);
    assert(span.last ? span.end == width : span.end < width);
    covered_ = span.last ? std::uint16_t{0} : span.end;
  }

 private:
  std::uint16_t covered_ = 0;
};

}  // namespace cigsim::priority_resolver
