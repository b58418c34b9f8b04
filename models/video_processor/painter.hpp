// SPDX-License-Identifier: MIT
// Edges to elements without spans: faces from the lowest priority to the highest, each over those
// before it. What remains on an element is the face of highest priority there, which is the
// resolver's answer. Cheaper than resolving while faces overlap little; it fills every hidden
// element too.
//
// The picture is made in bands of lines that stay in the processor's cache. The background is laid
// only where the last frame painted and the lowest face of the band does not.
#pragma once

#include <vector>

#include "models/edge_orderer/list_stepper.hpp"

namespace cigsim::video_processor {

template <class N>
class Painter {
 public:
  /// Faces must be in the order of their priority, highest first. `out` must be as the last call
  /// left it, unless forget() was called since.
  void compute(const EdgeList<N>& edges, const Colour& background, const Raster& raster,
               Picture& out);

  /// The picture has been written by another, or its size or background has changed.
  void forget() { painted_from_.clear(); }

  /// The stepper of the last frame's edges.
  const edge_orderer::ListStepper<N>& stepper() const { return stepper_; }

 private:
  // The crossings of a face on the lines [first, last) of a band, in left_ and right_ from place 0.
  struct Lines {
    int first = 0, last = 0;
  };

  void start(const Raster& raster, Picture& out);
  void sort_into_bands(const EdgeList<N>& edges, const Raster& raster);
  Lines cross(const EdgeList<N>& edges, const RasterFace& face, int begin, int end, int width);
  void lay_background(const Lines& lowest, int begin, int end, const Colour& background,
                      Picture& out);
  void paint(const RasterFace& face, const Lines& lines, Picture& out);

  edge_orderer::ListStepper<N> stepper_;
  int band_lines_ = 1;
  std::vector<std::vector<std::uint32_t>> band_faces_;  // ascending, by band
  std::vector<std::int32_t> left_, right_;
  std::vector<std::int32_t> painted_from_, painted_to_;  // by line: holds all that was painted
};

extern template class Painter<float>;
extern template class Painter<double>;
extern template class Painter<Certified>;
extern template class Painter<Exact>;

}  // namespace cigsim::video_processor
