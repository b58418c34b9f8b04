// SPDX-License-Identifier: MIT
#include "models/hidden_line/part.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace cigsim::hidden_line {
namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

Ends ends(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

}  // namespace

void connect_edges(Part& part) {
  std::map<Ends, std::uint32_t> known;
  part.edges.clear();
  for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
    PartFace& face = part.faces[f];
    face.edges.clear();
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      const std::uint32_t a = face.loop[i], b = face.loop[(i + 1) % face.loop.size()];
      const auto number = static_cast<std::uint32_t>(part.edges.size());
      const auto [at, fresh] = known.emplace(ends(a, b), number);
      if (fresh) {
        PartEdge edge;
        edge.a = a;
        edge.b = b;
        edge.number = number;
        part.edges.push_back(edge);
      }
      PartEdge& edge = part.edges[at->second];
      (edge.face[0] == kNoFace ? edge.face[0] : edge.face[1]) = f;
      face.edges.push_back(at->second);
    }
  }
}

Part solid_part(const Object& object, std::uint32_t number) {
  Part part;
  part.object = number;
  part.vertices = object.vertices;
  for (const Face& face : object.faces) {
    const auto corners = spanning_corners(part.vertices, face.vertices);
    if (!corners) throw std::invalid_argument("a face of a solid has no area");
    const auto [a, b, c] = *corners;
    part.faces.push_back(
        {face.vertices, plane_through(part.vertices[a], part.vertices[b], part.vertices[c]), {}});
  }
  connect_edges(part);
  return part;
}

Part figure_part(const std::vector<Vec3>& loop, std::uint32_t number) {
  Part part;
  part.kind = PartKind::kFigure;
  part.object = number;
  part.two_sided = true;
  part.vertices = loop;
  Loop corners;
  for (std::uint32_t v = 0; v < loop.size(); ++v) corners.push_back(v);
  const auto spanning = spanning_corners(loop, corners);
  const auto flat = FlatLoop::make(loop, corners);
  if (!spanning || !flat) throw std::invalid_argument("the figure has no area");
  const auto [a, b, c] = *spanning;
  const Plane plane = plane_through(loop[a], loop[b], loop[c]);
  if (!on_plane(plane, loop, corners))
    throw std::invalid_argument("the figure does not lie in one plane");
  part.faces.push_back({corners, plane, {}});
  connect_edges(part);
  if (is_convex(*flat, corners)) return part;
  Triangulation t = triangulate(*flat, corners);
  if (t.crossing) throw std::invalid_argument("the figure crosses itself");
  part.cells = join_convex(*flat, std::move(t.triangles));
  return part;
}

Part wire_part(const Object& object, std::uint32_t number) {
  Part part;
  part.kind = PartKind::kWire;
  part.object = number;
  part.vertices = object.vertices;
  std::map<Ends, bool> known;
  for (const Face& face : object.faces)
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
      const std::uint32_t a = face.vertices[i], b = face.vertices[(i + 1) % face.vertices.size()];
      if (a == b || !known.emplace(ends(a, b), true).second) continue;
      PartEdge edge;
      edge.a = a;
      edge.b = b;
      edge.number = static_cast<std::uint32_t>(part.edges.size());
      part.edges.push_back(edge);
    }
  return part;
}

}  // namespace cigsim::hidden_line
