// SPDX-License-Identifier: MIT
// Polygon clipping (Sutherland and Hodgman 1974, as Sandor 1979, sec. 4.3, tells it): one plane of
// the view box after the other, each of which takes a ring of vertices and gives another.
#pragma once

#include <vector>

#include "models/survey/clipping/observer.hpp"

namespace cigsim::survey {

struct PolygonWork {
  std::uint64_t vertices = 0;  ///< tested, over all planes
  std::uint64_t meetings = 0;  ///< computed
};

/// What is inside or on the view box, plane for plane: view plane, right, left, above, below; in
/// the observer's frame. Empty when nothing is. A concave polygon that a plane cuts into several
/// parts stays one ring, whose parts are joined by edges there and back along that plane, as
/// published: such edges have no area.
template <class N>
std::vector<Vec3T<N>> clip_polygon(std::vector<Vec3T<N>> ring, const ViewBox<N>& box,
                                   PolygonWork& work) {
  constexpr int kPlanes = 5;
  const auto inside_by = [&box](int plane, const Vec3T<N>& p) {
    switch (plane) {
      case 0:
        return N(p.z - box.d);
      case 1:
        return N(box.half_width * p.z - box.d * p.x);
      case 2:
        return N(box.half_width * p.z + box.d * p.x);
      case 3:
        return N(box.half_height * p.z - box.d * p.y);
      default:
        return N(box.half_height * p.z + box.d * p.y);
    }
  };
  std::vector<Vec3T<N>> out;
  for (int plane = 0; plane < kPlanes && !ring.empty(); ++plane) {
    out.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3T<N>& a = ring[i];
      const Vec3T<N>& b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const N da = inside_by(plane, a), db = inside_by(plane, b);
      ++work.vertices;
      if (da >= 0) out.push_back(a);
      if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
        ++work.meetings;
        const N t(da / (da - db));
        out.push_back(a + (b - a) * t);
      }
    }
    ring.swap(out);
  }
  if (ring.size() < 3) ring.clear();
  return ring;
}

}  // namespace cigsim::survey
