// SPDX-License-Identifier: MIT
#include "models/survey/visible_surface/face_list.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "models/edge_orderer/stepper.hpp"
#include "models/geometry_processor/clip.hpp"

namespace cigsim::survey {
namespace {

using geometry_processor::PyramidSides;
using ViewPoint = geometry_processor::ViewPoint<Exact>;

const Exact kHalf(0.5);

RoundedPlane round_plane(const DepthPlane& p, const Raster& raster) {
  RoundedPlane out{p.a.get_d(), p.b.get_d(), p.c.get_d(), 0};
  // Coefficients are off by 2^-52 of themselves, two products and two sums add 2^-53 each; the
  // constant covers what underflows.
  const double reach =
      std::abs(out.a) * raster.width + std::abs(out.b) * raster.height + std::abs(out.c);
  out.slack = 16 * 0x1p-53 * reach + 0x1p-960;
  return out;
}

class Builder {
 public:
  Builder(const ViewTransform& view, FaceList& out)
      : view_(view), sides_(view), eye_(convert<Exact>(view.eye)), out_(out) {
    rotation_ = convert<Exact>(view.rotation);
    const auto& [ru, rv, rw] = rotation_.row;
    columns_[0] = cross(rv, rw);
    columns_[1] = cross(rw, ru);
    columns_[2] = cross(ru, rv);
    determinant_ = dot(ru, columns_[0]);
    out_.raster = view.raster;
  }

  /// Adds the visible faces of an item; `rank` is that of its first face.
  void add(const FaceSet& set, const Item& item, bool ground) {
    transform(set, item);
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      const PreparedFace& face = set.faces[f];
      const int front = side(set.planes[face.plane], view_.eye);
      if (ground) ++rank_;
      if (front == 0 || (front < 0 && !face.two_sided)) continue;
      if (!project(set, face)) continue;
      const std::size_t before = out_.edges.size();
      if (!set_up(face, front > 0)) {
        out_.edges.resize(before);
        continue;
      }
      SurveyFace& made = out_.faces.back();
      made.rank = ground ? rank_ : 0;
      made.plane = plane_index(depth_plane(set.planes[face.plane]));
    }
  }

 private:
  void transform(const FaceSet& set, const Item& item) {
    points_.resize(item.vertex_count);
    for (std::uint32_t i = 0; i < item.vertex_count; ++i) {
      const ExactVec d = rotation_ * (position(set, item.first_vertex + i) - eye_);
      points_[i] = {d.x, d.y, d.z};
    }
  }

  static ExactVec position(const FaceSet& set, std::uint32_t vertex) {
    const ExactVec* exact = set.exact(vertex);
    return exact ? *exact : convert<Exact>(set.vertices[vertex]);
  }

  // The face's loop on the raster, clipped. False: it is outside.
  bool project(const FaceSet& set, const PreparedFace& face) {
    clipped_.clear();
    std::uint8_t any = 0, all = 0xf;
    for (std::uint32_t c = 0; c < face.corner_count; ++c) {
      clipped_.push_back(points_[set.corners[face.first_corner + c]]);
      const std::uint8_t code = sides_.outcode(clipped_.back());
      any |= code;
      all &= code;
    }
    if (all != 0) return false;
    if (any != 0) geometry_processor::clip(sides_, any, clipped_, scratch_);
    loop_.clear();
    for (const ViewPoint& p : clipped_) {
      if (sgn(p.u) <= 0) return false;
      const Exact scale(sides_.focal() / p.u);
      loop_.push_back({Exact(sides_.half_width() + p.v * scale - kHalf),
                       Exact(sides_.half_height() - p.w * scale - kHalf)});
    }
    return loop_.size() >= 3;
  }

  // Edges and rows of the loop, which runs anticlockwise when the face is seen from its front, so
  // that left edges run down. False: no line passes through it.
  bool set_up(const PreparedFace& face, bool front) {
    SurveyFace made;
    made.object = face.object;
    made.colour = face.colour;
    made.first_line = view_.raster.height;
    const std::size_t first_edge = out_.edges.size();
    drawn_.clear();
    for (std::size_t i = 0; i < loop_.size(); ++i) add_edge(i, front, made);
    if (out_.edges.size() == first_edge) return false;
    fill_rows(first_edge, made);
    made.first_place = static_cast<std::uint32_t>(out_.places.size());
    made.place_count = static_cast<std::uint32_t>(loop_.size());
    out_.places.insert(out_.places.end(), loop_.begin(), loop_.end());
    out_.faces.push_back(std::move(made));
    return true;
  }

  void add_edge(std::size_t i, bool front, SurveyFace& made) {
    const RasterPlace& a = loop_[i];
    const RasterPlace& b = loop_[i + 1 < loop_.size() ? i + 1 : 0];
    const bool down = a.y < b.y;
    const RasterPlace& top = down ? a : b;
    const RasterPlace& bottom = down ? b : a;
    Edge<Exact> edge;
    edge.first_line = ceil_clamped(top.y, 0, view_.raster.height);
    edge.end_line = ceil_clamped(bottom.y, 0, view_.raster.height);
    if (edge.first_line >= edge.end_line) return;
    edge.left = down == front;
    edge.slope = Exact((bottom.x - top.x) / (bottom.y - top.y));
    edge.x = Exact(top.x + edge.slope * (edge.first_line - top.y));
    made.first_line = std::min(made.first_line, edge.first_line);
    made.end_line = std::max(made.end_line, edge.end_line);
    out_.edges.push_back(
        {static_cast<std::uint32_t>(out_.faces.size()), edge.first_line, edge.end_line, edge.left});
    drawn_.push_back(std::move(edge));
  }

  void fill_rows(std::size_t first_edge, SurveyFace& made) {
    made.first_row = static_cast<std::uint32_t>(out_.rows.size());
    out_.rows.resize(out_.rows.size() + static_cast<std::size_t>(made.end_line - made.first_line));
    elements_.resize(static_cast<std::size_t>(view_.raster.height));
    for (std::size_t e = 0; e < drawn_.size(); ++e) {
      const SurveyEdge& edge = out_.edges[first_edge + e];
      edge_orderer::step_edge(drawn_[e], edge.first_line, edge.end_line, view_.raster.width,
                              elements_.data());
      for (int r = edge.first_line; r < edge.end_line; ++r) {
        Row& row = out_.rows[made.row(r)];
        (edge.left ? row.first : row.end) =
            static_cast<std::uint16_t>(elements_[static_cast<std::size_t>(r - edge.first_line)]);
      }
    }
    made.first_element = view_.raster.width;
    for (int r = made.first_line; r < made.end_line; ++r) {
      Row& row = out_.rows[made.row(r)];
      row.end = std::max(row.end, row.first);  // pieces of moving models are not quite planar
      if (row.first == row.end) continue;
      made.first_element = std::min<int>(made.first_element, row.first);
      made.end_element = std::max<int>(made.end_element, row.end);
    }
  }

  // From n . (p - p0) = 0 in the environment to 1/u over the raster: with q = R (p - eye) and
  // q = u (1, (x - W/2) / f, (H/2 - y) / f).
  DepthPlane depth_plane(const Plane& plane) const {
    const ExactVec n = exact_normal(plane);
    const Exact distance = dot(n, convert<Exact>(plane.exact.p) - eye_);
    const Exact scale(1 / Exact(determinant_ * distance * sides_.focal()));
    const Exact u(dot(n, columns_[0]) * scale), v(dot(n, columns_[1]) * scale),
        w(dot(n, columns_[2]) * scale);
    return {v, Exact(-w),
            Exact(u * sides_.focal() + v * (kHalf - sides_.half_width()) +
                  w * (sides_.half_height() - kHalf))};
  }

  std::uint32_t plane_index(DepthPlane&& plane) {
    const RoundedPlane rounded = round_plane(plane, view_.raster);
    const auto bits = [](double d) { return std::bit_cast<std::uint64_t>(d); };
    const std::uint64_t key =
        (bits(rounded.a) * 0x9e3779b97f4a7c15u + bits(rounded.b)) * 0x9e3779b97f4a7c15u +
        bits(rounded.c);
    auto& same = known_[key];
    for (const std::uint32_t p : same) {
      const DepthPlane& q = out_.planes[p];
      if (q.a == plane.a && q.b == plane.b && q.c == plane.c) return p;
    }
    same.push_back(static_cast<std::uint32_t>(out_.planes.size()));
    out_.planes.push_back(std::move(plane));
    out_.rounded.push_back(rounded);
    return same.back();
  }

  const ViewTransform& view_;
  PyramidSides<Exact> sides_;
  ExactVec eye_;
  Mat3T<Exact> rotation_;
  ExactVec columns_[3];  // of the inverse, times the determinant
  Exact determinant_;
  FaceList& out_;
  std::uint32_t rank_ = 0;
  std::vector<ViewPoint> points_, clipped_, scratch_;
  std::vector<RasterPlace> loop_;
  std::vector<Edge<Exact>> drawn_;
  std::vector<std::int32_t> elements_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> known_;
};

// Puts the faces, which stand in the order of their priority, into that of the input, where
// `origin` tells of each where it comes from.
void order_by_input(const std::vector<std::tuple<std::uint32_t, std::uint32_t>>& origin,
                    FaceList& list) {
  const std::size_t count = list.faces.size();
  std::vector<std::uint32_t> order(count), place(count);
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t f) {
    return std::tuple(list.faces[f].rank, list.faces[f].object, origin[f], f);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<SurveyFace> faces;
  faces.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    place[order[i]] = i;
    faces.push_back(list.faces[order[i]]);
  }
  list.faces = std::move(faces);
  list.priority = std::move(place);  // face k of the priority order stands at place[k]
  for (SurveyEdge& edge : list.edges) edge.face = list.priority[edge.face];
}

}  // namespace

FaceList make_face_list(const ViewTransform& view, const FaceSet* const (&sets)[3],
                        const std::vector<ItemRef>& items) {
  FaceList list;
  Builder builder(view, list);
  std::vector<std::tuple<std::uint32_t, std::uint32_t>> origin;
  for (const ItemRef& ref : items) {
    const std::size_t set = static_cast<std::size_t>(ref.set);
    builder.add(*sets[set], sets[set]->items[ref.item], ref.set == SetId::kGround);
    origin.resize(list.faces.size(), {static_cast<std::uint32_t>(set), ref.item});
  }
  list.clusters = items.size();
  order_by_input(origin, list);
  return list;
}

}  // namespace cigsim::survey
