// SPDX-License-Identifier: MIT
#include "models/video_processor/painter.hpp"

#include <algorithm>

#include "models/numeric/dispatch.hpp"
#include "models/video_processor/fill.hpp"

namespace cigsim::video_processor {
namespace {

constexpr int kBandBytes = 1 << 18;
constexpr int kElementBytes = sizeof(std::uint32_t) + sizeof(std::uint16_t);

// Lines of one face, from the left crossing to the right one. `from` and `to` grow to hold them.
CIGSIM_DISPATCH
void paint_lines(const std::int32_t* left, const std::int32_t* right, int lines, int width,
                 std::uint32_t colour, std::uint16_t number, std::uint32_t* colours,
                 std::uint16_t* numbers, std::int32_t* from, std::int32_t* to) {
  for (int k = 0; k < lines; ++k) {
    from[k] = std::min(from[k], left[k]);
    to[k] = std::max(to[k], right[k]);
  }
  for (int k = 0; k < lines; ++k, colours += width, numbers += width)
    if (left[k] < right[k])
      fill_run(colours + left[k], numbers + left[k], right[k] - left[k], colour, number);
}

CIGSIM_DISPATCH
void paint_run(std::uint32_t colour, int count, std::uint32_t* colours, std::uint16_t* numbers) {
  fill_run(colours, numbers, count, colour, 0);
}

}  // namespace

template <class N>
void Painter<N>::compute(const EdgeList<N>& edges, const Colour& background, const Raster& raster,
                         Picture& out) {
  start(raster, out);
  sort_into_bands(edges, raster);
  stepper_.begin();
  for (std::size_t band = 0; band < band_faces_.size(); ++band) {
    const int begin = static_cast<int>(band) * band_lines_;
    const int end = std::min(begin + band_lines_, raster.height);
    const std::vector<std::uint32_t>& faces = band_faces_[band];
    Lines lines;
    if (!faces.empty()) lines = cross(edges, edges.faces[faces.back()], begin, end, raster.width);
    lay_background(lines, begin, end, background, out);
    if (faces.empty()) continue;
    paint(edges.faces[faces.back()], lines, out);
    for (auto f = faces.rbegin() + 1; f != faces.rend(); ++f)
      paint(edges.faces[*f], cross(edges, edges.faces[*f], begin, end, raster.width), out);
  }
}

template <class N>
void Painter<N>::start(const Raster& raster, Picture& out) {
  const std::size_t height = static_cast<std::size_t>(raster.height);
  out.fit(raster);
  if (painted_from_.size() == height) return;
  painted_from_.assign(height, 0);
  painted_to_.assign(height, raster.width);
}

template <class N>
void Painter<N>::lay_background(const Lines& lowest, int begin, int end, const Colour& background,
                                Picture& out) {
  const std::uint32_t colour = packed(background);
  for (int r = begin; r < end; ++r) {
    const std::size_t row = static_cast<std::size_t>(r) * static_cast<std::size_t>(out.width);
    const auto lay = [&](std::int32_t from, std::int32_t to) {
      if (from < to)
        paint_run(colour, to - from, out.colours.data() + row + from,
                  out.numbers.data() + row + from);
    };
    std::int32_t& from = painted_from_[static_cast<std::size_t>(r)];
    std::int32_t& to = painted_to_[static_cast<std::size_t>(r)];
    const bool covered = r >= lowest.first && r < lowest.last;
    const std::int32_t left = covered ? left_[static_cast<std::size_t>(r - lowest.first)] : 0;
    const std::int32_t right = covered ? right_[static_cast<std::size_t>(r - lowest.first)] : 0;
    if (left < right) {
      lay(from, std::min(to, left));
      lay(std::max(from, right), to);
    } else {
      lay(from, to);
    }
    from = out.width;
    to = 0;
  }
}

template <class N>
void Painter<N>::sort_into_bands(const EdgeList<N>& edges, const Raster& raster) {
  band_lines_ = std::max(1, kBandBytes / (kElementBytes * raster.width));
  left_.resize(static_cast<std::size_t>(band_lines_));
  right_.resize(static_cast<std::size_t>(band_lines_));
  band_faces_.resize(static_cast<std::size_t>((raster.height + band_lines_ - 1) / band_lines_));
  for (auto& faces : band_faces_) faces.clear();
  for (std::uint32_t f = 0; f < edges.faces.size(); ++f) {
    const int last = (edges.faces[f].end_line - 1) / band_lines_;
    for (int band = edges.faces[f].first_line / band_lines_; band <= last; ++band)
      band_faces_[static_cast<std::size_t>(band)].push_back(f);
  }
}

template <class N>
typename Painter<N>::Lines Painter<N>::cross(const EdgeList<N>& edges, const RasterFace& face,
                                             int begin, int end, int width) {
  const Lines lines{std::max(begin, face.first_line), std::min(end, face.end_line)};
  for (std::uint32_t e = face.first_edge; e < face.first_edge + face.edge_count; ++e) {
    const Edge<N>& edge = edges.edges[e];
    const int from = std::max(begin, edge.first_line), to = std::min(end, edge.end_line);
    if (from < to)
      stepper_.step(edges, e, from, to, width,
                    (edge.left ? left_ : right_).data() + (from - lines.first));
  }
  return lines;
}

template <class N>
void Painter<N>::paint(const RasterFace& face, const Lines& lines, Picture& out) {
  const std::size_t first = static_cast<std::size_t>(lines.first);
  const std::size_t row = first * static_cast<std::size_t>(out.width);
  paint_lines(left_.data(), right_.data(), lines.last - lines.first, out.width, packed(face.colour),
              number_of(face.object), out.colours.data() + row, out.numbers.data() + row,
              painted_from_.data() + first, painted_to_.data() + first);
}

template class Painter<float>;
template class Painter<double>;
template class Painter<Certified>;
template class Painter<Exact>;

}  // namespace cigsim::video_processor
