// SPDX-License-Identifier: MIT
// Geometry processor, functional level (Sandor 1979, sec. 4.3 and 5.1; back faces also Stump 1986,
// ch. II): vertices into the viewpoint system, back faces out, faces clipped and projected, edges
// set up for the raster.
//
// In double, the error of a projected edge is about the rounding of the vertices over the distance
// of the eyepoint from the face's plane. A face that the eyepoint sees so nearly edge on that this
// could reach a thousandth of an element is worked out in rational arithmetic instead.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/geometry_processor/clip.hpp"

namespace cigsim::geometry_processor {

/// The face sets of a frame, by SetId.
using FrameSets = std::array<const FaceSet*, 3>;

/// The nearest double to a quantity of an edge that is worked out exactly; beyond the doubles, a
/// very large one, so that no place on a line becomes infinity less infinity.
inline double edge_double(const Exact& value) {
  constexpr double kMost = 0x1p1000;
  return std::clamp(to_double(value), -kMost, kMost);
}

template <class N>
class Functional {
 public:
  /// Faces come out in the order of `items` and, within an item, in its own order.
  void compute(const ViewTransform& view, const FrameSets& sets, std::span<const ItemRef> items,
               EdgeList<N>& out) {
    out.faces.clear();
    out.edges.clear();
    start(view);
    for (const ItemRef& ref : items) {
      const FaceSet& set = *sets[static_cast<std::size_t>(ref.set)];
      const Item& item = set.items[ref.item];
      transform(set, item);
      if (all_codes_ != 0) continue;
      for (std::uint32_t f = 0; f < item.face_count; ++f) process(set, item, f, out);
    }
  }

  /// One face of an item by itself; appends to `out`.
  void compute_face(const ViewTransform& view, const FaceSet& set, const Item& item,
                    std::uint32_t face, EdgeList<N>& out) {
    start(view);
    transform(set, item);
    if (all_codes_ == 0) process(set, item, face, out);
  }

  /// +1 when the eyepoint is in front of the face, -1 behind, 0 in its plane.
  static int facing(const Plane& plane, const Vec3& eye) {
    if constexpr (std::is_same_v<N, float>) {
      const float value =
          dot(convert<float>(plane.normal), convert<float>(eye) - convert<float>(plane.exact.p));
      return value > 0 ? 1 : value < 0 ? -1 : 0;
    } else {
      return side(plane, eye);
    }
  }

 private:
  // Outcode of a point at the eyepoint itself, which lies outside no side plane and has no place on
  // the raster.
  static constexpr std::uint8_t kAtEye = 0x10;

  struct RasterPoint {
    N x{}, y{};
  };

  void start(const ViewTransform& view) {
    view_ = &view;
    sides_ = PyramidSides<N>(view);
    eye_ = convert<N>(view.eye);
    rotation_ = convert<N>(view.rotation);
    // Four roundings of 2^-53 a coordinate, times the focal length, below 2^-10 elements.
    edge_on_ = 0x1p-40 * (view.focal + view.raster.width + view.raster.height);
  }

  void transform(const FaceSet& set, const Item& item) {
    points_.resize(item.vertex_count);
    raster_.resize(item.vertex_count);
    codes_.resize(item.vertex_count);
    all_codes_ = 0xf;
    if constexpr (std::is_same_v<N, double>) {
      // Vertices of cuts are rounded where they lie in the environment.
      const Vec3& c = item.sphere.centre;
      reach_ = std::abs(c.x) + std::abs(c.y) + std::abs(c.z) + 2 * item.sphere.radius;
    }
    for (std::uint32_t i = 0; i < item.vertex_count; ++i) {
      const Vec3T<N> d = position(set, item.first_vertex + i) - eye_;
      if constexpr (std::is_same_v<N, double>)
        reach_ = std::max(reach_, std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
      points_[i] = {dot(rotation_.row[0], d), dot(rotation_.row[1], d), dot(rotation_.row[2], d)};
      codes_[i] = sides_.outcode(points_[i]);
      all_codes_ &= codes_[i];
      if (codes_[i] != 0) continue;
      if (points_[i].u > 0)
        raster_[i] = project(points_[i]);
      else
        codes_[i] = kAtEye;
    }
  }

  static Vec3T<N> position(const FaceSet& set, std::uint32_t vertex) {
    if constexpr (is_exact<N>)
      if (const ExactVec* exact = set.exact(vertex)) return *exact;
    return convert<N>(set.vertices[vertex]);
  }

  RasterPoint project(const ViewPoint<N>& p) const {
    const N scale(sides_.focal() / p.u);
    return {N(sides_.half_width() + p.v * scale), N(sides_.half_height() - p.w * scale)};
  }

  // True when the eyepoint is too near the plane for doubles (see above).
  bool nearly_edge_on(const Plane& plane) const {
    const Vec3 d = view_->eye - plane.exact.p;
    const double value = dot(plane.normal, d), bound = edge_on_ * reach_;
    return !(value * value > bound * bound * dot(plane.normal, plane.normal));
  }

  void process_exactly(const FaceSet& set, const Item& item, std::uint32_t face, EdgeList<N>& out) {
    if (!exact_) exact_ = std::make_unique<Functional<Exact>>();
    EdgeList<Exact> edges;
    exact_->compute_face(*view_, set, item, face, edges);
    for (RasterFace made : edges.faces) {
      made.first_edge = static_cast<std::uint32_t>(out.edges.size());
      for (const Edge<Exact>& e : edges.edges)
        out.edges.push_back(
            {e.first_line, e.end_line, e.left, edge_double(e.x), edge_double(e.slope)});
      out.faces.push_back(made);
    }
  }

  void process(const FaceSet& set, const Item& item, std::uint32_t index, EdgeList<N>& out) {
    const PreparedFace& face = set.faces[item.first_face + index];
    if constexpr (std::is_same_v<N, double>) {
      if (nearly_edge_on(set.planes[face.plane])) {
        process_exactly(set, item, index, out);
        return;
      }
    }
    const int front = facing(set.planes[face.plane], view_->eye);
    if (front == 0 || (front < 0 && !face.two_sided)) return;
    const std::uint32_t* corners = set.corners.data() + face.first_corner;
    std::uint8_t any = 0, all = 0xf;
    for (std::uint32_t c = 0; c < face.corner_count; ++c) {
      any |= codes_[corners[c]];
      all &= codes_[corners[c]];
    }
    if (all != 0) return;
    loop_.clear();
    if (any == 0) {
      for (std::uint32_t c = 0; c < face.corner_count; ++c) loop_.push_back(raster_[corners[c]]);
    } else {
      clipped_.clear();
      for (std::uint32_t c = 0; c < face.corner_count; ++c) clipped_.push_back(points_[corners[c]]);
      clip(sides_, any, clipped_, scratch_);
      for (const ViewPoint<N>& p : clipped_) {
        if (!(p.u > 0)) return;  // rounding in a face that the eyepoint sees almost edge on
        loop_.push_back(project(p));
      }
    }
    set_up(face, front > 0, view_->raster, out);
  }

  /// Edges of the projected loop. A front face runs anticlockwise on the raster, so its left edges
  /// run down.
  void set_up(const PreparedFace& face, bool front, const Raster& raster, EdgeList<N>& out) {
    RasterFace made;
    made.object = face.object;
    made.colour = face.colour;
    made.first_edge = static_cast<std::uint32_t>(out.edges.size());
    made.first_line = raster.height;
    double twice_area = 0;
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const RasterPoint& a = loop_[i];
      const RasterPoint& b = loop_[i + 1 < loop_.size() ? i + 1 : 0];
      twice_area += to_double(a.x) * to_double(b.y) - to_double(b.x) * to_double(a.y);
      const bool down = a.y < b.y;
      const RasterPoint& top = down ? a : b;
      const RasterPoint& bottom = down ? b : a;
      Edge<N> edge;
      edge.first_line = ceil_clamped(N(top.y - half()), 0, raster.height);
      edge.end_line = ceil_clamped(N(bottom.y - half()), 0, raster.height);
      if (edge.first_line >= edge.end_line) continue;
      edge.left = down == front;
      edge.slope = N((bottom.x - top.x) / (bottom.y - top.y));
      const N drop(N(edge.first_line) + half() - top.y);
      edge.x = N(top.x + edge.slope * drop);
      // On a single line a nearly level edge may lose its place to rounding, but not its extent.
      if (!is_exact<N> && edge.end_line - edge.first_line == 1)
        edge.x = std::clamp(edge.x, std::min(top.x, bottom.x), std::max(top.x, bottom.x));
      edge.x = N(edge.x - half());
      made.first_line = std::min(made.first_line, edge.first_line);
      made.end_line = std::max(made.end_line, edge.end_line);
      out.edges.push_back(edge);
    }
    made.edge_count = static_cast<std::uint32_t>(out.edges.size()) - made.first_edge;
    made.area = static_cast<float>(std::abs(twice_area) / 2);
    if (made.edge_count > 0) out.faces.push_back(made);
  }

  static N half() { return from_double<N>(0.5); }

  const ViewTransform* view_ = nullptr;
  PyramidSides<N> sides_;
  Vec3T<N> eye_;
  Mat3T<N> rotation_;
  double edge_on_ = 0;  // faces below this times their reach, in height of the eyepoint, are exact
  double reach_ = 0;    // of the item's vertices from the eyepoint and from the origin
  std::unique_ptr<Functional<Exact>> exact_;

  std::vector<ViewPoint<N>> points_, clipped_, scratch_;
  std::vector<RasterPoint> raster_, loop_;
  std::vector<std::uint8_t> codes_;
  std::uint8_t all_codes_ = 0;
};

}  // namespace cigsim::geometry_processor
