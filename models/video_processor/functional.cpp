// SPDX-License-Identifier: MIT
#include "models/video_processor/functional.hpp"

#include <algorithm>

#include "models/numeric/dispatch.hpp"

namespace cigsim::video_processor {
namespace {

std::uint32_t packed(const Colour& c) {
  return 0xff000000u | std::uint32_t{c.b} << 16 | std::uint32_t{c.g} << 8 | c.r;
}

std::uint16_t number_of(std::uint32_t object) {
  return static_cast<std::uint16_t>(std::min(object, 65535u));
}

// Fills whole blocks of W elements, the last of which may overlap the one before; shorter runs in
// smaller blocks.
template <class T, int W>
[[gnu::always_inline]] inline void fill(T* first, int count, T value) {
  if constexpr (W == 1) {
    if (count == 1) *first = value;
  } else if (count < W) {
    fill<T, W / 2>(first, count, value);
  } else {
    typedef T Block __attribute__((vector_size(W * sizeof(T)), aligned(alignof(T)), may_alias));
    const Block block = value - Block{};
    for (int i = 0; i + W <= count; i += W) *reinterpret_cast<Block*>(first + i) = block;
    *reinterpret_cast<Block*>(first + count - W) = block;
  }
}

CIGSIM_DISPATCH
void fill_line(std::span<const Span> spans, std::span<const RasterFace> faces,
               std::uint32_t background, std::uint32_t* colours, std::uint16_t* numbers) {
  for (const Span& span : spans) {
    const bool shown = span.face != kNone;
    const int count = span.end - span.first;
    fill<std::uint32_t, 8>(colours + span.first, count,
                           shown ? packed(faces[span.face].colour) : background);
    fill<std::uint16_t, 16>(numbers + span.first, count,
                            shown ? number_of(faces[span.face].object) : std::uint16_t{0});
  }
}

}  // namespace

void Functional::compute(const priority_resolver::SpanLines& spans,
                         std::span<const RasterFace> faces, const Colour& background,
                         const Raster& raster, Picture& out) {
  out.width = raster.width;
  out.height = raster.height;
  const std::size_t width = static_cast<std::size_t>(raster.width);
  out.colours.resize(width * static_cast<std::size_t>(raster.height));
  out.numbers.resize(out.colours.size());
  for (int r = 0; r < raster.height; ++r) {
    const std::size_t row = static_cast<std::size_t>(r) * width;
    fill_line(spans.line(r), faces, packed(background), out.colours.data() + row,
              out.numbers.data() + row);
  }
}

}  // namespace cigsim::video_processor
