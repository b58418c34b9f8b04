// SPDX-License-Identifier: MIT
#include "models/video_processor/painter.hpp"

#include <algorithm>

#include "models/numeric/dispatch.hpp"
#include "models/video_processor/fill.hpp"

namespace cigsim::video_processor {
namespace {

constexpr int kBandBytes = 1 << 18;
constexpr int kElementBytes = sizeof(std::uint32_t) + sizeof(std::uint16_t);

// Lines of one face, from the left crossing to the right one.
CIGSIM_DISPATCH
void paint_lines(const std::int32_t* left, const std::int32_t* right, int lines, int width,
                 std::uint32_t colour, std::uint16_t number, std::uint32_t* colours,
                 std::uint16_t* numbers) {
  for (int k = 0; k < lines; ++k, colours += width, numbers += width)
    if (left[k] < right[k])
      fill_run(colours + left[k], numbers + left[k], right[k] - left[k], colour, number);
}

CIGSIM_DISPATCH
void paint_background(std::uint32_t colour, int count, std::uint32_t* colours,
                      std::uint16_t* numbers) {
  fill_run(colours, numbers, count, colour, 0);
}

}  // namespace

template <class N>
void Painter<N>::compute(const EdgeList<N>& edges, const Colour& background, const Raster& raster,
                         Picture& out) {
  out.width = raster.width;
  out.height = raster.height;
  const std::size_t width = static_cast<std::size_t>(raster.width);
  out.colours.resize(width * static_cast<std::size_t>(raster.height));
  out.numbers.resize(out.colours.size());
  sort_into_bands(edges, raster);
  for (std::size_t band = 0; band < band_faces_.size(); ++band) {
    const int begin = static_cast<int>(band) * band_lines_;
    const int end = std::min(begin + band_lines_, raster.height);
    const std::size_t row = static_cast<std::size_t>(begin) * width;
    paint_background(packed(background), (end - begin) * raster.width, out.colours.data() + row,
                     out.numbers.data() + row);
    const std::vector<std::uint32_t>& faces = band_faces_[band];
    for (auto f = faces.rbegin(); f != faces.rend(); ++f)
      paint(edges, edges.faces[*f], begin, end, out);
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
void Painter<N>::paint(const EdgeList<N>& edges, const RasterFace& face, int begin, int end,
                       Picture& out) {
  for (std::uint32_t e = face.first_edge; e < face.first_edge + face.edge_count; ++e) {
    const Edge<N>& edge = edges.edges[e];
    const int from = std::max(begin, edge.first_line), to = std::min(end, edge.end_line);
    if (from < to)
      edge_orderer::step_edge(edge, from, to, out.width,
                              (edge.left ? left_ : right_).data() + (from - begin));
  }
  const int first = std::max(begin, face.first_line), last = std::min(end, face.end_line);
  const std::size_t row = static_cast<std::size_t>(first) * static_cast<std::size_t>(out.width);
  paint_lines(left_.data() + (first - begin), right_.data() + (first - begin), last - first,
              out.width, packed(face.colour), number_of(face.object), out.colours.data() + row,
              out.numbers.data() + row);
}

template class Painter<float>;
template class Painter<double>;
template class Painter<Exact>;

}  // namespace cigsim::video_processor
