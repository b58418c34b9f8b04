// SPDX-License-Identifier: MIT
// Edges to elements without spans: faces from the lowest priority to the highest, each over those
// before it. What remains on an element is the face of highest priority there, which is the
// resolver's answer. Cheaper than resolving while faces overlap little; it fills every hidden
// element too.
//
// The picture is made in bands of lines that stay in the processor's cache.
#pragma once

#include <vector>

#include "models/edge_orderer/stepper.hpp"

namespace cigsim::video_processor {

template <class N>
class Painter {
 public:
  /// Faces must be in the order of their priority, highest first.
  void compute(const EdgeList<N>& edges, const Colour& background, const Raster& raster,
               Picture& out);

 private:
  void sort_into_bands(const EdgeList<N>& edges, const Raster& raster);
  void paint(const EdgeList<N>& edges, const RasterFace& face, int begin, int end, Picture& out);

  int band_lines_ = 1;
  std::vector<std::vector<std::uint32_t>> band_faces_;  // ascending, by band
  std::vector<std::int32_t> left_, right_;
};

extern template class Painter<float>;
extern template class Painter<double>;
extern template class Painter<Exact>;

}  // namespace cigsim::video_processor
