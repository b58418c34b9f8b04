// SPDX-License-Identifier: MIT
// The faces of a frame and the elements where their edges cross the lines, whichever numbers the
// machine computed with: what reports and measures look at beside the picture.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "models/edge_orderer/list_stepper.hpp"
#include "models/numeric/machine_word.hpp"

namespace cigsim {

/// An edge of a face. It has an element on each of the lines [first_line, end_line).
struct FaceEdge {
  int first_line = 0, end_line = 0;
  bool left = false;
  double x = 0, slope = 0;        ///< as Edge, rounded to doubles
  std::size_t first_element = 0;  ///< into FrameFaces::elements
};

/// Faces from the highest priority to the lowest, before a machine's lines drop any.
struct FrameFaces {
  std::vector<RasterFace> faces;
  std::vector<FaceEdge> edges;         ///< as RasterFace::first_edge and edge_count say
  std::vector<std::int32_t> elements;  ///< first element at or right of the edge, 0..width

  std::span<const FaceEdge> edges_of(std::size_t face) const {
    return std::span(edges).subspan(faces[face].first_edge, faces[face].edge_count);
  }
  /// Those of an edge, line by line.
  std::span<const std::int32_t> elements_of(const FaceEdge& edge) const {
    return std::span(elements).subspan(edge.first_element,
                                       static_cast<std::size_t>(edge.end_line - edge.first_line));
  }
};

namespace detail {

inline void step(const EdgeList<MachineWord>& list, std::uint32_t e, int width,
                 std::int32_t* element) {
  const Edge<MachineWord>& edge = list.edges[e];
  std::int64_t x = edge.x.raw;  // EO1, EO2
  std::uint64_t overflows = 0;
  for (int r = edge.first_line; r < edge.end_line; ++r) {
    const std::int64_t up = (x + ((1 << kRasterFraction) - 1)) >> kRasterFraction;
    *element++ = static_cast<std::int32_t>(std::clamp<std::int64_t>(up, 0, width));
    x = saturate(x + edge.slope.raw, 8 * sizeof(Word), overflows);
  }
}

template <class N>
void step(const EdgeList<N>& list, std::uint32_t e, int width, std::int32_t* element) {
  edge_orderer::ListStepper<N>().step(list, e, list.edges[e].first_line, list.edges[e].end_line,
                                      width, element);
}

}  // namespace detail

template <class N>
FrameFaces frame_faces(const EdgeList<N>& list, const Raster& raster) {
  FrameFaces out;
  out.faces = list.faces;
  out.edges.reserve(list.edges.size());
  for (std::uint32_t e = 0; e < list.edges.size(); ++e) {
    const Edge<N>& edge = list.edges[e];
    FaceEdge& made = out.edges.emplace_back();
    made.first_line = edge.first_line;
    made.end_line = edge.end_line;
    made.left = edge.left;
    made.x = to_double(edge.x);
    made.slope = to_double(edge.slope);
    made.first_element = out.elements.size();
    out.elements.resize(made.first_element +
                        static_cast<std::size_t>(edge.end_line - edge.first_line));
    detail::step(list, e, raster.width, out.elements.data() + made.first_element);
  }
  return out;
}

}  // namespace cigsim
