// SPDX-License-Identifier: MIT
// Bounds, with e = 2^-53 the unit round-off, r the largest number of the rotation, |.| the sum of a
// vector's magnitudes, f the focal length, h the larger half side of the raster.
//
// Vertices. A difference d = p - eye is off by e of itself, and where a cut has been rounded by 2 e
// of p's coordinate; each product of a dot product by e of itself, the two sums by e each. So a
// coordinate of the viewpoint system is off by less than r e (4.01 |d| + 2 |p|). `error` is twice
// that, which covers its own rounding, and is at least 8 e times any coordinate.
//
// Distances from a side, h u - f v and the like: (f + h) error for their terms, 3 e (f + h) times
// the largest coordinate, so (3/8) (f + h) error, for products and sum: below spread() times error
// with spread() = 1.5 (f + h).
//
// Projection of a point within the pyramid, where |v/u| <= h/f: f v'/u' - f v/u, with v' and u' as
// computed, is f (v' - v)/u' + f (v/u) (u - u')/u', below (f + h) error / u'; rounding adds less
// than `rounding_`, which has room for all that is computed on the raster below.
//
// Cuts. With a, b the distances of the inner and the outer end, a share t = a / (a + b) whose
// distances are off by D at most is off by D / (a' + b'), as |a' b - a b'| <= D (a + b). A cut
// point is off by its ends' error, by the length between them times that, and by roundings which 8
// e times any coordinate covers.
//
// Edges. Let E bound the error of both end points in x and y, S be the true slope and s the
// computed points' one. An end point is off the true line by E (1 + |S|) along the raster line. |S
// - s| is below 2 E (1 + |S|) / rise, so with rise > 8 E, 1 + |S| is below 4/3 (1 + |s|). Sample
// lines lie between the true end points, so within E of the computed ones: between them the
// deviation is that of an end point at most, and a quarter more just beyond. That makes 5/3 E (1 +
// |s|). The slope's three roundings, those of the first column and those of each step add less than
// 14 e (width + 2), for all columns are within the raster or a fraction of an element from it, and
// E holds `rounding_` = 128 e (width + height): 2 E (1 + |s|) in all.
//
// What overflows becomes infinite or no number and fails each test for certainty; what underflows
// is covered by `least_`.
#include "models/geometry_processor/functional_certified.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim::geometry_processor {
namespace {

constexpr std::uint8_t kSides = 0xf;
// A vertex that is outside no side, yet has no place on the raster that doubles could tell: at the
// eyepoint or next to it.
constexpr std::uint8_t kUnplaced = 0x10;

double size(double x, double y, double z) { return std::abs(x) + std::abs(y) + std::abs(z); }

}  // namespace

void Functional<Certified>::compute(const ViewTransform& view, const FrameSets& sets,
                                    std::span<const ItemRef> items, EdgeList<Certified>& out) {
  out.faces.clear();
  out.edges.clear();
  out.exact.clear();
  out.view = view;
  out.sets = sets;
  redone_ = {};
  start(view);
  for (const ItemRef& ref : items) {
    const FaceSet& set = *sets[static_cast<std::size_t>(ref.set)];
    const Item& item = set.items[ref.item];
    set_id_ = ref.set;
    transform(set, item);
    if (all_codes_ != 0) continue;
    for (std::uint32_t f = 0; f < item.face_count; ++f)
      process(set, item, item.first_face + f, out);
  }
  out.redone = redone_;
}

void Functional<Certified>::start(const ViewTransform& view) {
  view_ = &view;
  half_width_ = view.raster.width / 2.0;
  half_height_ = view.raster.height / 2.0;
  double largest = 0;
  for (const Vec3& row : view.rotation.row)
    largest = std::max({largest, std::abs(row.x), std::abs(row.y), std::abs(row.z)});
  unit_ = caution_ * largest * 0x1p-50;
  least_ = caution_ * 0x1p-1000;
  clip_ = CertifiedClip(view);
  projected_ = clip_.spread() / view.focal;
  rounding_ = caution_ * 0x1p-46 * (view.raster.width + view.raster.height);
}

void Functional<Certified>::transform(const FaceSet& set, const Item& item) {
  points_.resize(item.vertex_count);
  places_.resize(item.vertex_count);
  codes_.resize(item.vertex_count);
  all_codes_ = kSides;
  cut_unit_ = set.cut_vertices.empty() ? 0 : unit_;
  redone_.vertices += item.vertex_count;
  for (std::uint32_t i = 0; i < item.vertex_count; ++i) {
    points_[i] = viewpoint_position(set.vertices[item.first_vertex + i]);
    classify(set, item, i);
    all_codes_ &= codes_[i];
  }
}

CertifiedPoint Functional<Certified>::viewpoint_position(const Vec3& vertex) const {
  const Vec3 d = vertex - view_->eye;
  const Mat3& m = view_->rotation;
  return {dot(m.row[0], d), dot(m.row[1], d), dot(m.row[2], d),
          unit_ * size(d.x, d.y, d.z) + cut_unit_ * size(vertex.x, vertex.y, vertex.z) + least_};
}

void Functional<Certified>::classify(const FaceSet& set, const Item& item, std::uint32_t i) {
  const CertifiedPoint& p = points_[i];
  const double wide = half_width_ * p.u, high = half_height_ * p.u;
  const double right = view_->focal * p.v, up = view_->focal * p.w;
  const double margin = clip_.spread() * p.error;
  if (wide - std::abs(right) > margin && high - std::abs(up) > margin) {
    codes_[i] = 0;
    places_[i] = project(p);
    if (!find_line(places_[i])) classify_exactly(set, item.first_vertex + i, i);
    return;
  }
  std::uint8_t outside = 0;
  bool doubt = false;
  const double distances[] = {wide + right, wide - right, high - up, high + up};
  for (int side = 0; side < 4; ++side) {
    const bool out = distances[side] < -margin;
    outside |= static_cast<std::uint8_t>(out << side);
    doubt |= !out && !(distances[side] > margin);
  }
  codes_[i] = outside;
  if (doubt) classify_exactly(set, item.first_vertex + i, i);
}

void Functional<Certified>::classify_exactly(const FaceSet& set, std::uint32_t vertex,
                                             std::uint32_t i) {
  ++redone_.vertices_redone;
  const auto& [axes, sides] = clip_.exact();
  const auto [u, v, w] = exact_direction(set, vertex, axes);
  codes_[i] = sides.outcode({u, v, w});
  if (codes_[i] != 0) return;
  if (u.sign() <= 0 || !(points_[i].u > 2 * points_[i].error)) {
    codes_[i] = kUnplaced;
    return;
  }
  places_[i] = project(points_[i]);
  places_[i].line = first_line(places_[i], u, w);
}

// The first line whose sample is not above a point within the pyramid: half_height - focal w/u -
// 1/2, rounded up. Where the place is known to half an element, that is one of two.
int Functional<Certified>::first_line(const Place& place, const Dyadic& u, const Dyadic& w) const {
  const Dyadic above = Dyadic(half_height_ - 0.5) * u - Dyadic(view_->focal) * w;
  if (place.error < 0.5) {
    const int line = static_cast<int>(std::floor(place.y));
    return std::clamp(line + (Dyadic(line) * u < above), 0, view_->raster.height);
  }
  const int exponent = u.exponent_or(0), common = std::min(exponent, above.exponent_or(exponent));
  mpz_class line;
  mpz_cdiv_q(line.get_mpz_t(), above.whole(common).get_mpz_t(), u.whole(common).get_mpz_t());
  return std::clamp(static_cast<int>(line.get_si()), 0, view_->raster.height);
}

Functional<Certified>::Place Functional<Certified>::project(const CertifiedPoint& p) const {
  const double scale = view_->focal / p.u;
  return {half_width_ + p.v * scale, half_height_ - p.w * scale,
          projected_ * p.error * scale + rounding_, 0};
}

// The first sample at or below y is at the nearest whole number and a half. False: in doubt.
bool Functional<Certified>::find_line(Place& place) const {
  if (!(place.error < 0.5)) return false;
  place.line = static_cast<int>(place.y + 0.5);
  return std::abs(place.y - place.line) < 0.5 - place.error;
}

void Functional<Certified>::process(const FaceSet& set, const Item& item, std::uint32_t index,
                                    EdgeList<Certified>& out) {
  const PreparedFace& face = set.faces[index];
  const int front = side(set.planes[face.plane], view_->eye);
  if (front == 0 || (front < 0 && !face.two_sided)) return;
  const std::uint32_t* corners = set.corners.data() + face.first_corner;
  std::uint8_t any = 0, all = kSides;
  for (std::uint32_t c = 0; c < face.corner_count; ++c) {
    any |= codes_[corners[c]];
    all &= codes_[corners[c]];
  }
  if (all != 0) return;
  ++redone_.faces;
  if (any != 0 && ((any & kUnplaced) != 0 || !clip(set, item, face, any) || !place_loop())) {
    process_exactly(set, item, face, out);
    return;
  }
  redone_.faces_redone += any != 0 && clip_.settled();
  begin_face(face, out);
  if (any == 0) {
    for (std::uint32_t c = 0; c < face.corner_count; ++c) {
      const std::uint32_t a = corners[c], b = corners[c + 1 < face.corner_count ? c + 1 : 0];
      add_edge(places_[a], places_[b], {a, b}, item, front > 0, out);
    }
  } else {
    for (std::size_t i = 0; i < loop_.size(); ++i)
      add_edge(loop_places_[i], loop_places_[i + 1 < loop_.size() ? i + 1 : 0], loop_[i].edge, item,
               front > 0, out);
  }
  end_face(out);
}

void Functional<Certified>::process_exactly(const FaceSet& set, const Item& item,
                                            const PreparedFace& face, EdgeList<Certified>& out) {
  ++redone_.faces_redone;
  one_face_.clear();
  one_face_.planes.push_back(set.planes[face.plane]);
  one_face_.faces.push_back(face);
  one_face_.faces[0].first_corner = one_face_.faces[0].plane = 0;
  one_face_.items.push_back({0, 1, 0, face.corner_count, item.sphere});
  for (std::uint32_t c = 0; c < face.corner_count; ++c) {
    const std::uint32_t vertex = item.first_vertex + set.corners[face.first_corner + c];
    one_face_.corners.push_back(c);
    one_face_.vertices.push_back(set.vertices[vertex]);
    if (const ExactVec* cut = set.exact(vertex)) one_face_.cut_vertices.push_back({c, *cut});
  }
  exact_edges_.faces.clear();
  exact_edges_.edges.clear();
  exact_.compute_face(*view_, one_face_, one_face_.items[0], 0, exact_edges_);
  for (RasterFace made : exact_edges_.faces) {
    made.first_edge = static_cast<std::uint32_t>(out.edges.size());
    for (Edge<Exact>& e : exact_edges_.edges) {
      const double x = edge_double(e.x), slope = edge_double(e.slope);
      // An edge so nearly level that doubles hardly hold it: every crossing is in doubt.
      constexpr double kLarge = 0x1p900;
      const bool steep = std::abs(x) > kLarge || std::abs(slope) > kLarge;
      out.edges.push_back({e.first_line, e.end_line, e.left, set_id_, x, slope,
                           steep ? 1.0 : rounding_, kNone,
                           static_cast<std::uint32_t>(out.exact.size())});
      out.exact.push_back(std::move(e));
    }
    out.faces.push_back(made);
  }
}

// False: a decision is in doubt.
bool Functional<Certified>::clip(const FaceSet& set, const Item& item, const PreparedFace& face,
                                 std::uint8_t sides) {
  loop_.clear();
  const std::uint32_t* corners = set.corners.data() + face.first_corner;
  for (std::uint32_t c = 0; c < face.corner_count; ++c) {
    const std::uint32_t a = corners[c], b = corners[c + 1 < face.corner_count ? c + 1 : 0];
    loop_.push_back({points_[a], {a, b}, a, codes_[a], 0, {}, 0});
  }
  return clip_.clip(sides, set, item.first_vertex, loop_);
}

// False: a line is in doubt.
bool Functional<Certified>::place_loop() {
  loop_places_.clear();
  for (const LoopCorner& corner : loop_) {
    if (corner.vertex != kNone) {
      loop_places_.push_back(places_[corner.vertex]);
      continue;
    }
    if (!(corner.at.u > 2 * corner.at.error)) return false;
    loop_places_.push_back(project(corner.at));
    if (!find_line(loop_places_.back())) return false;
  }
  return true;
}

void Functional<Certified>::begin_face(const PreparedFace& face, const EdgeList<Certified>& out) {
  made_ = {};
  made_.object = face.object;
  made_.colour = face.colour;
  made_.first_edge = static_cast<std::uint32_t>(out.edges.size());
  made_.first_line = view_->raster.height;
  twice_area_ = 0;
}

// A front face runs anticlockwise on the raster, so its left edges run down.
void Functional<Certified>::add_edge(const Place& a, const Place& b, const LoopLine& line,
                                     const Item& item, bool front, EdgeList<Certified>& out) {
  twice_area_ += a.x * b.y - b.x * a.y;
  if (a.line == b.line) return;
  const bool down = a.line < b.line;
  const Place& top = down ? a : b;
  const Place& bottom = down ? b : a;
  Edge<Certified> edge;
  edge.first_line = top.line;
  edge.end_line = bottom.line;
  edge.left = down == front;
  edge.set = set_id_;
  if (line.a == kNone) {  // along the border, left or right: those above and below are level
    edge.from = kNone;
    edge.x = (line.b == 0 ? 0 : view_->raster.width) - 0.5;
  } else {
    edge.from = item.first_vertex + line.a;
    edge.to = item.first_vertex + line.b;
    const double error = std::max(a.error, b.error), rise = bottom.y - top.y;
    edge.slope = (bottom.x - top.x) / rise;
    edge.x = top.x + edge.slope * (edge.first_line + 0.5 - top.y) - 0.5;
    edge.bound = 2 * error * (1 + std::abs(edge.slope));
    if (!(rise > 8 * error) || !(edge.bound < 0.5)) {
      edge.x = edge.slope = 0;
      edge.bound = 1;
    }
  }
  made_.first_line = std::min(made_.first_line, edge.first_line);
  made_.end_line = std::max(made_.end_line, edge.end_line);
  out.edges.push_back(edge);
}

void Functional<Certified>::end_face(EdgeList<Certified>& out) {
  made_.edge_count = static_cast<std::uint32_t>(out.edges.size()) - made_.first_edge;
  made_.area = static_cast<float>(std::abs(twice_area_) / 2);
  if (made_.edge_count > 0) out.faces.push_back(made_);
}

}  // namespace cigsim::geometry_processor
