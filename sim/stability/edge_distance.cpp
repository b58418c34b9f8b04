// SPDX-License-Identifier: MIT
#include "sim/stability/edge_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/numeric/orientation2.hpp"

namespace cigsim::stability {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double t =
      length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0;
  return std::hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

// Of a point of the raster from an edge given in the viewpoint system.
double to_edge(const ViewTransform& view, const Vec2& p, Vec3 a, Vec3 b) {
  if (a.x > b.x) std::swap(a, b);
  // Ahead of the eyepoint by a little of the edge's own size: the rest lies far off the raster.
  const double least = 0x1p-30 * std::max({std::abs(a.y), std::abs(a.z), std::abs(b.x),
                                           std::abs(b.y), std::abs(b.z)});
  if (!(b.x > least)) return kInfinity;
  if (a.x < least) a = a + (b - a) * ((least - a.x) / (b.x - a.x));
  const auto project = [&](const Vec3& q) {
    return Vec2{view.raster.width / 2.0 + view.focal * q.y / q.x,
                view.raster.height / 2.0 - view.focal * q.z / q.x};
  };
  return to_segment(p, project(a), project(b));
}

}  // namespace

double distance_to_edges(const ViewTransform& view, const geometry_processor::FrameSets& sets,
                         std::span<const ItemRef> items, std::uint32_t a, std::uint32_t b,
                         int column, int row) {
  const Vec2 p{column + 0.5, row + 0.5};
  double nearest = kInfinity;
  for (const ItemRef& ref : items) {
    const FaceSet& set = *sets[static_cast<std::size_t>(ref.set)];
    const Item& item = set.items[ref.item];
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      const PreparedFace& face = set.faces[f];
      if (face.object != a && face.object != b) continue;
      const auto corner = [&](std::uint32_t c) {
        return view.rotation *
               (set.vertices[item.first_vertex + set.corners[face.first_corner + c]] - view.eye);
      };
      for (std::uint32_t c = 0; c < face.corner_count; ++c)
        nearest =
            std::min(nearest, to_edge(view, p, corner(c), corner((c + 1) % face.corner_count)));
    }
  }
  return nearest;
}

}  // namespace cigsim::stability
