// SPDX-License-Identifier: MIT
// Video processor, functional level: spans become elements in flat colours.
#pragma once

#include "models/priority_resolver/spans.hpp"

namespace cigsim::video_processor {

class Functional {
 public:
  void compute(const priority_resolver::SpanLines& spans, std::span<const RasterFace> faces,
               const Colour& background, const Raster& raster, Picture& out);
};

}  // namespace cigsim::video_processor
