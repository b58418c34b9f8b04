// SPDX-License-Identifier: MIT
// Video processor, functional level: spans become elements in flat colours.
#pragma once

#include <algorithm>

#include "models/priority_resolver/spans.hpp"

namespace cigsim::video_processor {

inline std::uint32_t packed(const Colour& c) {
  return 0xff000000u | std::uint32_t{c.b} << 16 | std::uint32_t{c.g} << 8 | c.r;
}

class Functional {
 public:
  void compute(const priority_resolver::SpanLines& spans, std::span<const RasterFace> faces,
               const Colour& background, const Raster& raster, Picture& out) {
    out.width = raster.width;
    out.height = raster.height;
    const std::size_t elements = static_cast<std::size_t>(raster.width) * raster.height;
    out.colours.resize(elements);
    out.numbers.resize(elements);
    for (int r = 0; r < raster.height; ++r) {
      std::uint32_t* colours = out.colours.data() + static_cast<std::size_t>(r) * raster.width;
      std::uint16_t* numbers = out.numbers.data() + static_cast<std::size_t>(r) * raster.width;
      for (const Span& span : spans.line(r)) {
        const bool shown = span.face != kNone;
        const std::uint32_t colour = packed(shown ? faces[span.face].colour : background);
        const std::uint32_t object = shown ? faces[span.face].object : 0;
        std::fill(colours + span.first, colours + span.end, colour);
        std::fill(numbers + span.first, numbers + span.end,
                  static_cast<std::uint16_t>(std::min(object, 65535u)));
      }
    }
  }
};

}  // namespace cigsim::video_processor
