// SPDX-License-Identifier: MIT
// Steps 2 to 4 of the algorithm (Levine 1975, ch. VI.F): classes of edges, projection, windows.
#include <algorithm>
#include <cmath>
#include <limits>

#include "models/hidden_line/hidden_lines.hpp"

namespace cigsim::hidden_line {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// True when all points certainly lie outside one side of the pyramid of vision, or behind the eye.
bool out_of_view(const ViewTransform& view, const std::vector<SeenPoint>& points) {
  const double width = view.raster.width / 2.0, height = view.raster.height / 2.0;
  int outside[5] = {};
  for (const SeenPoint& p : points) {
    const double slack = 0x1p-45 * p.size * (width + height + view.focal);
    const double f = view.focal;
    outside[0] += width * p.u + f * p.v < -slack;
    outside[1] += width * p.u - f * p.v < -slack;
    outside[2] += height * p.u - f * p.w < -slack;
    outside[3] += height * p.u + f * p.w < -slack;
    outside[4] += p.u < -0x1p-45 * p.size;
  }
  const auto all = static_cast<int>(points.size());
  return std::any_of(std::begin(outside), std::end(outside), [&](int n) { return n == all; });
}

}  // namespace

HiddenLines::Window HiddenLines::window_of(const SeenPoint& a, const SeenPoint& b) {
  if (!a.ahead || !b.ahead) return {-kInfinity, kInfinity, -kInfinity, kInfinity};
  return {std::min(a.x - a.margin, b.x - b.margin), std::max(a.x + a.margin, b.x + b.margin),
          std::min(a.y - a.margin, b.y - b.margin), std::max(a.y + a.margin, b.y + b.margin)};
}

void HiddenLines::see(std::size_t index) {
  const Part& part = set_.parts[index];
  SeenPart& seen = seen_[index];
  seen.points.clear();
  for (const Vec3& v : part.vertices) seen.points.push_back(eye_.see(v));
  seen.active = !out_of_view(eye_.view(), seen.points);
  seen.ahead = std::all_of(seen.points.begin(), seen.points.end(),
                           [](const SeenPoint& p) { return p.ahead; });
  std::fill(seen.invisibility.begin(), seen.invisibility.end(), kUnknown);
  std::fill(seen.display.begin(), seen.display.end(), 0);
  for (Shadow& cell : seen.cells) cell.clear();
  seen.concave.clear();
  if (!seen.active) return;
  classify_faces(part, seen);
  if (part.kind == PartKind::kSolid) classify_solid(part, seen);
  if (part.kind == PartKind::kWire) {
    std::fill(seen.kind.begin(), seen.kind.end(), EdgeKind::kFront);
    std::fill(seen.display.begin(), seen.display.end(), 1);
  }
}

void HiddenLines::classify_faces(const Part& part, SeenPart& seen) {
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    const int s = side(part.faces[f].plane, eye_.view().eye);
    seen.front[f] = static_cast<std::int8_t>(s > 0 || part.two_sided ? s : 0);
    counters_.front_faces += seen.front[f] != 0;
  }
}

void HiddenLines::classify_solid(const Part& part, SeenPart& seen) {
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    const PartEdge& edge = part.edges[e];
    int front = 0;
    for (const std::uint32_t f : edge.face) front += f != kNoFace && seen.front[f] != 0;
    seen.kind[e] = front == 2   ? EdgeKind::kFront
                   : front == 1 ? EdgeKind::kExtreme
                                : EdgeKind::kBack;
    seen.display[e] = front > 0 && (edge.drawn == Drawn::kAlways ||
                                    (edge.drawn == Drawn::kWhenExtreme && front == 1));
  }
}

// A seam is closed when two of its faces are seen and lie on its two sides: then it is no outline.
void HiddenLines::resolve_seams() {
  for (std::size_t s = 0; s < set_.seams.size(); ++s) {
    bool left = false, right = false;
    for (const SeamSide& at : set_.seams[s]) {
      const SeenPart& seen = seen_[at.part];
      if (!seen.active || seen.front[0] == 0) continue;
      const PartEdge& edge = set_.parts[at.part].edges[at.edge];
      const SeenPoint &a = seen.points[edge.a], &b = seen.points[edge.b];
      // The same way along the seam for all sides.
      const Vec3 &p = a.position, &q = b.position;
      const bool forward = p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
      for (const SeenPoint& c : seen.points) {
        const int turn = forward ? eye_.turn(a, b, c) : eye_.turn(b, a, c);
        if (turn == 0) continue;
        (turn > 0 ? left : right) = true;
        break;
      }
    }
    seam_closed_[s] = left && right;
  }
}

void HiddenLines::classify_figure(std::size_t index) {
  const Part& part = set_.parts[index];
  SeenPart& seen = seen_[index];
  // A sheet seen edge on is a line; the face of a body is not seen then.
  const bool shown = seen.front[0] != 0 || part.two_sided;
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    const PartEdge& edge = part.edges[e];
    seen.kind[e] = EdgeKind::kExtreme;
    bool display = shown && edge.drawn != Drawn::kNever;
    if (edge.seam != kNoSeam) {
      if (edge.drawn == Drawn::kWhenExtreme && seam_closed_[edge.seam]) display = false;
      // The first of the seam's faces that is shown draws it.
      for (const SeamSide& at : set_.seams[edge.seam]) {
        if (at.part == index) break;
        const SeenPart& other = seen_[at.part];
        if (other.active && (other.front[0] != 0 || set_.parts[at.part].two_sided)) display = false;
      }
    }
    seen.display[e] = display;
  }
}

void HiddenLines::make_cells(std::size_t index) {
  const Part& part = set_.parts[index];
  SeenPart& seen = seen_[index];
  if (!seen.active || part.kind == PartKind::kWire || part.marking) return;
  if (part.kind == PartKind::kSolid) {
    Shadow& cell = seen.cells.front();
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      if (seen.front[f] == 0) continue;
      const PartFace& face = part.faces[f];
      cell.fronts.push_back({&face.plane, 1});
      for (std::size_t i = 0; i < face.loop.size(); ++i)
        if (seen.kind[face.edges[i]] == EdgeKind::kExtreme)
          cell.outline.push_back({SightPlane(seen.points[face.loop[i]],
                                             seen.points[face.loop[(i + 1) % face.loop.size()]]),
                                  false});
    }
    return;
  }
  const int front = seen.front[0];
  if (front == 0) return;
  const PartFace& face = part.faces[0];
  const auto line = [&](std::uint32_t a, std::uint32_t b, bool closed) -> OutlinePlane {
    if (front < 0) std::swap(a, b);
    return {SightPlane(seen.points[a], seen.points[b]), closed};
  };
  const auto next = [](const Loop& loop, std::size_t i) { return loop[(i + 1) % loop.size()]; };
  if (part.cells.empty()) {
    Shadow& cell = seen.cells.front();
    cell.fronts.push_back({&face.plane, front});
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      const std::uint32_t seam = part.edges[face.edges[i]].seam;
      cell.outline.push_back(
          line(face.loop[i], next(face.loop, i), seam != kNoSeam && seam_closed_[seam]));
    }
    return;
  }
  for (std::size_t i = 0; i < face.loop.size(); ++i)
    seen.concave.push_back(line(face.loop[i], next(face.loop, i), false));
  for (std::size_t c = 0; c < part.cells.size(); ++c) {
    const Loop& loop = part.cells[c];
    seen.cells[c].fronts.push_back({&face.plane, front});
    for (std::size_t i = 0; i < loop.size(); ++i) {
      // A diagonal is no edge of the loop round the whole face.
      const std::uint32_t a = loop[i], b = next(loop, i);
      const bool edge = (a + 1) % part.vertices.size() == b || (b + 1) % part.vertices.size() == a;
      seen.cells[c].outline.push_back(line(a, b, !edge));
    }
  }
}

void HiddenLines::make_windows(std::size_t index) {
  SeenPart& seen = seen_[index];
  if (!seen.active) return;
  seen.window = {kInfinity, -kInfinity, kInfinity, -kInfinity};
  for (const SeenPoint& p : seen.points) {
    const Window w = window_of(p, p);
    seen.window = {std::min(seen.window.left, w.left), std::max(seen.window.right, w.right),
                   std::min(seen.window.low, w.low), std::max(seen.window.high, w.high)};
  }
  seen.rectangles.clear();
  for (const OutlinePlane& o : seen.outline())
    seen.rectangles.push_back(window_of(*o.plane.p, *o.plane.q));
}

}  // namespace cigsim::hidden_line
