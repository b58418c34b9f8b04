// SPDX-License-Identifier: MIT
// Clipping of a face to the pyramid of vision in the viewpoint system, plane by plane (Sutherland
// and Hodgman, as Sandor 1979 describes). The four side planes meet in the eyepoint, so what they
// leave of a face whose plane does not pass through the eyepoint lies ahead of it: the division by
// u needs no hither plane.
#pragma once

#include <cstdint>
#include <vector>

#include "models/boundary/transactions.hpp"

namespace cigsim::geometry_processor {

/// A point of the viewpoint system: u ahead, v right, w up.
template <class N>
struct ViewPoint {
  N u{}, v{}, w{};
};

/// Signed distances from the side planes, in raster units times u; negative is outside.
template <class N>
class PyramidSides {
 public:
  PyramidSides() = default;
  explicit PyramidSides(const ViewTransform& view)
      : focal_(from_double<N>(view.focal)),
        half_width_(from_double<N>(view.raster.width / 2.0)),
        half_height_(from_double<N>(view.raster.height / 2.0)) {}

  static constexpr int kCount = 4;

  N distance(int plane, const ViewPoint<N>& p) const {
    switch (plane) {
      case 0:
        return N(half_width_ * p.u + focal_ * p.v);
      case 1:
        return N(half_width_ * p.u - focal_ * p.v);
      case 2:
        return N(half_height_ * p.u - focal_ * p.w);
      default:
        return N(half_height_ * p.u + focal_ * p.w);
    }
  }

  /// Bit i is set when the point is outside plane i.
  std::uint8_t outcode(const ViewPoint<N>& p) const {
    const N wide(half_width_ * p.u), high(half_height_ * p.u);
    const N right(focal_ * p.v), up(focal_ * p.w);
    return static_cast<std::uint8_t>((wide + right < 0) | (wide - right < 0) << 1 |
                                     (high - up < 0) << 2 | (high + up < 0) << 3);
  }

  N focal() const { return focal_; }
  N half_width() const { return half_width_; }
  N half_height() const { return half_height_; }

 private:
  N focal_{}, half_width_{}, half_height_{};
};

/// Clips a convex loop in place against the planes of `codes`; `scratch` is working memory. A cut
/// is computed from the inner end towards the outer, so that two faces cut their common edge alike.
template <class N>
void clip(const PyramidSides<N>& sides, std::uint8_t codes, std::vector<ViewPoint<N>>& loop,
          std::vector<ViewPoint<N>>& scratch) {
  for (int plane = 0; plane < PyramidSides<N>::kCount; ++plane) {
    if (!(codes >> plane & 1)) continue;
    scratch.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const ViewPoint<N>& a = loop[i];
      const ViewPoint<N>& b = loop[i + 1 < loop.size() ? i + 1 : 0];
      const N da = sides.distance(plane, a), db = sides.distance(plane, b);
      const bool a_in = da >= 0, b_in = db >= 0;
      if (a_in) scratch.push_back(a);
      if (a_in == b_in) continue;
      const ViewPoint<N>& in = a_in ? a : b;
      const ViewPoint<N>& out = a_in ? b : a;
      const N d_in = a_in ? da : db, d_out = a_in ? db : da;
      const N t(d_in / (d_in - d_out));
      scratch.push_back({N(in.u + (out.u - in.u) * t), N(in.v + (out.v - in.v) * t),
                         N(in.w + (out.w - in.w) * t)});
    }
    loop.swap(scratch);
  }
}

}  // namespace cigsim::geometry_processor
