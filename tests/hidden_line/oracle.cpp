// SPDX-License-Identifier: MIT
#include "tests/hidden_line/oracle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "models/frame_calculator/functional.hpp"
#include "models/hidden_line/scene_parts.hpp"
#include "sim/functional_machine.hpp"

namespace cigsim::test {
namespace {

using hidden_line::Part;
using hidden_line::PartFace;
using hidden_line::PartKind;
using hidden_line::Piece;

Exact value(const Plane& plane, const ExactVec& p) {
  return dot(exact_normal(plane), p - convert<Exact>(plane.exact.p));
}

// The ray eye + s (point - eye), 0 < s < 1, has a point strictly behind every face.
Sight hides_solid(const Part& part, const ExactVec& eye, const ExactVec& point) {
  Exact low = 0, high = 1;
  bool eye_in = true;
  for (const PartFace& face : part.faces) eye_in = eye_in && sgn(value(face.plane, eye)) <= 0;
  if (eye_in) return Sight::kClear;
  for (const PartFace& face : part.faces) {
    const Exact at_eye = value(face.plane, eye), at_point = value(face.plane, point);
    if (at_eye >= 0 && at_point >= 0) return Sight::kClear;
    if (at_eye < 0 && at_point < 0) continue;
    const Exact s = at_eye / (at_eye - at_point);
    if (at_eye >= 0)
      low = std::max(low, s);
    else
      high = std::min(high, s);
  }
  return low < high ? Sight::kHidden : Sight::kClear;
}

struct Flat {
  Exact x, y;
};

// Winding in the coordinate plane in which the figure is largest.
Sight hides_figure(const Part& part, const ExactVec& eye, const ExactVec& point) {
  const PartFace& face = part.faces[0];
  const Exact at_eye = value(face.plane, eye), at_point = value(face.plane, point);
  if (sgn(at_eye) == 0 || (sgn(at_eye) < 0 && !part.two_sided)) return Sight::kClear;
  if (sgn(at_eye) * sgn(at_point) > 0) return Sight::kClear;
  if (sgn(at_point) == 0) return Sight::kBoundary;
  const ExactVec foot = eye + (point - eye) * Exact(at_eye / (at_eye - at_point));
  const ExactVec n = exact_normal(face.plane);
  const int axis = sgn(n.x) != 0 ? 0 : sgn(n.y) != 0 ? 1 : 2;
  const auto flat = [&](const ExactVec& p) -> Flat {
    return axis == 0 ? Flat{p.y, p.z} : axis == 1 ? Flat{p.z, p.x} : Flat{p.x, p.y};
  };
  const Flat f = flat(foot);
  bool inside = false;
  for (std::size_t i = 0; i < face.loop.size(); ++i) {
    const Flat a = flat(convert<Exact>(part.vertices[face.loop[i]]));
    const Flat b = flat(convert<Exact>(part.vertices[face.loop[(i + 1) % face.loop.size()]]));
    const int turn = sgn(Exact((b.x - a.x) * (f.y - a.y) - (b.y - a.y) * (f.x - a.x)));
    if (turn == 0 && std::min(a.x, b.x) <= f.x && f.x <= std::max(a.x, b.x) &&
        std::min(a.y, b.y) <= f.y && f.y <= std::max(a.y, b.y))
      return Sight::kBoundary;
    const bool a_above = a.y > f.y, b_above = b.y > f.y;
    if (a_above != b_above && (turn > 0) == b_above) inside = !inside;
  }
  return inside ? Sight::kHidden : Sight::kClear;
}

std::string where(const hidden_line::HiddenLines& lines, const Piece& piece, double t) {
  const Part& part = lines.parts()[piece.part];
  return fmt::format("part {} (object {}) edge {}, t {:.17g} in {:.17g}..{:.17g} called {}",
                     piece.part, part.object, piece.edge, t, piece.from, piece.to,
                     piece.visible ? "visible" : "hidden");
}

// Objects wholly out of view are left out of a frame, so that only what is in view has an answer.
bool in_view(const ViewTransform& view, const ExactVec& point) {
  const ExactVec p = convert<Exact>(view.rotation) * (point - convert<Exact>(view.eye));
  const Exact wide = p.x * view.raster.width / 2, high = p.x * view.raster.height / 2;
  const Exact f(view.focal);
  return p.x > 0 && abs(Exact(p.y * f)) <= wide && abs(Exact(p.z * f)) <= high;
}

// The source calls an edge between a face seen edge on and one turned away a back edge. On the
// raster it lies on the outline, where a front edge is drawn.
bool runs_along_a_face(const Part& part, const Vec3& eye, const ExactVec& point) {
  return std::any_of(part.faces.begin(), part.faces.end(), [&](const PartFace& face) {
    return side(face.plane, eye) == 0 && sgn(value(face.plane, point)) == 0;
  });
}

// Kept as one answer: hidden when a part hides for certain.
Sight sight_of(const hidden_line::HiddenLines& lines, std::size_t own, const Vec3& eye,
               const ExactVec& point) {
  Sight answer = Sight::kClear;
  const std::vector<Part>& parts = lines.parts();
  for (std::size_t m = 0; m < parts.size(); ++m) {
    if (m == own && parts[m].kind != PartKind::kSolid) continue;
    const Sight s = m == own && runs_along_a_face(parts[m], eye, point)
                        ? Sight::kBoundary
                        : hides(parts[m], eye, point);
    if (s == Sight::kHidden) return s;
    if (s == Sight::kBoundary) answer = s;
  }
  return answer;
}

}  // namespace

Sight hides(const Part& part, const Vec3& eye, const ExactVec& point) {
  if (part.kind == PartKind::kWire || part.marking) return Sight::kClear;
  const ExactVec e = convert<Exact>(eye);
  return part.kind == PartKind::kSolid ? hides_solid(part, e, point) : hides_figure(part, e, point);
}

std::string check_pieces(const hidden_line::HiddenLines& lines, const ViewTransform& view,
                         int per_piece, SampleCounts& counts) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Piece>> by_edge;
  if (lines.disagreements() != 0)
    return fmt::format("{} vertices with two counts", lines.disagreements());
  for (const Piece& piece : lines.pieces()) {
    by_edge[{piece.part, piece.edge}].push_back(piece);
    if (piece.to - piece.from < 1e-9) continue;
    const Part& part = lines.parts()[piece.part];
    const ExactVec a = convert<Exact>(part.vertices[part.edges[piece.edge].a]);
    const ExactVec b = convert<Exact>(part.vertices[part.edges[piece.edge].b]);
    for (int k = 0; k < per_piece; ++k) {
      // Nowhere near the middle: two shadows may meet there in a point.
      const double share = per_piece == 1 ? 0.48713 : 0.00137 + 0.99711 * k / (per_piece - 1);
      const double t = piece.from + (piece.to - piece.from) * share;
      const ExactVec point = a + (b - a) * Exact(t);
      if (!in_view(view, point)) continue;
      const Sight s = sight_of(lines, piece.part, view.eye, point);
      ++counts.samples;
      counts.boundary += s == Sight::kBoundary;
      counts.hidden += s == Sight::kHidden;
      if (s != Sight::kBoundary && (s == Sight::kClear) != piece.visible)
        return where(lines, piece, t);
    }
  }
  for (auto& [edge, pieces] : by_edge) {
    std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
      return std::pair(p.from, p.to) < std::pair(q.from, q.to);
    });
    double end = 0;
    for (const Piece& piece : pieces) {
      if (std::abs(piece.from - end) > 1e-9)
        return "gap or overlap before " + where(lines, piece, piece.from);
      end = piece.to;
    }
    if (std::abs(end - 1) > 1e-9) return "gap after " + where(lines, pieces.back(), end);
  }
  return "";
}

std::string check_invisibility(const hidden_line::HiddenLines& lines, const ViewTransform& view) {
  const std::vector<Part>& parts = lines.parts();
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t v = 0; v < parts[p].vertices.size(); ++v) {
      const int found = lines.invisibility(p, v);
      const ExactVec point = convert<Exact>(parts[p].vertices[v]);
      if (found == hidden_line::HiddenLines::kUnknown || !in_view(view, point)) continue;
      int count = 0;
      for (std::size_t m = 0; m < parts.size(); ++m)
        count += m != p && hides(parts[m], view.eye, point) == Sight::kHidden;
      if (count != found)
        return fmt::format("part {} vertex {}: {} objects hide it, not {}", p, v, count, found);
    }
  return "";
}

ViewTransform view_from(const Vec3& eye, const Vec3& target) {
  return frame_calculator::view_transform({look_at(eye, target), 60}, {1024, 1024});
}

hidden_line::PartSet parts_of(const Environment& environment) {
  std::vector<Placement> placements;
  for (const CoordinateSystem& system : environment.systems) placements.push_back(system.placement);
  Notices notices;
  return hidden_line::scene_parts(environment, placements, {}, notices);
}

}  // namespace cigsim::test
