// SPDX-License-Identifier: MIT
#include "models/video_processor/functional.hpp"

#include "models/numeric/dispatch.hpp"
#include "models/video_processor/fill.hpp"

namespace cigsim::video_processor {
namespace {

CIGSIM_DISPATCH
void fill_line(std::span<const Span> spans, std::span<const RasterFace> faces,
               std::uint32_t background, std::uint32_t* colours, std::uint16_t* numbers) {
  for (const Span& span : spans) {
    const bool shown = span.face != kNone;
    const int count = span.end - span.first;
    fill_run(colours + span.first, numbers + span.first, count,
             shown ? packed(faces[span.face].colour) : background,
             shown ? number_of(faces[span.face].object) : std::uint16_t{0});
  }
}

}  // namespace

void Functional::compute(const priority_resolver::SpanLines& spans,
                         std::span<const RasterFace> faces, const Colour& background,
                         const Raster& raster, Picture& out) {
  out.fit(raster);
  const std::size_t width = static_cast<std::size_t>(raster.width);
  for (int r = 0; r < raster.height; ++r) {
    const std::size_t row = static_cast<std::size_t>(r) * width;
    fill_line(spans.line(r), faces, packed(background), out.colours.data() + row,
              out.numbers.data() + row);
  }
}

}  // namespace cigsim::video_processor
