// SPDX-License-Identifier: MIT
#include "models/hidden_line/scene_parts.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "models/database/surface.hpp"
#include "models/environment/detail.hpp"
#include "models/environment/placement.hpp"

namespace cigsim::hidden_line {
namespace {

// Two faces of a surface between which the input has no edge to be seen.
bool one_face(const Object& object, const Surface& surface, std::uint32_t f, std::uint32_t g) {
  const SurfaceFace &a = surface.faces[f], &b = surface.faces[g];
  if (a.source == b.source) return true;
  return object.faces[a.source].colour == object.faces[b.source].colour &&
         dot(a.plane.normal, b.plane.normal) > 0 && on_plane(a.plane, surface.vertices, b.loop);
}

// Nothing when edges of the joined faces do not meet two and two.
std::optional<Part> solid(const Object& object, const Surface& surface, std::uint32_t number) {
  Part part;
  part.object = number;
  part.vertices = surface.vertices;
  for (const SurfaceFace& face : surface.faces) part.faces.push_back({face.loop, face.plane, {}});
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const PartFace& face : part.faces)
    for (std::size_t i = 0; i < face.loop.size(); ++i)
      ++sides[std::minmax(face.loop[i], face.loop[(i + 1) % face.loop.size()])];
  if (std::any_of(sides.begin(), sides.end(), [](const auto& side) { return side.second != 2; }))
    return std::nullopt;
  connect_edges(part);
  for (PartEdge& edge : part.edges)
    if (one_face(object, surface, edge.face[0], edge.face[1])) edge.drawn = Drawn::kWhenExtreme;
  return part;
}

std::optional<Part> plane_figure(const Object& object, std::uint32_t number) {
  if (object.faces.size() != 1) return std::nullopt;
  std::vector<Vec3> loop;
  for (const std::uint32_t v : object.faces.front().vertices) {
    if (std::find(loop.begin(), loop.end(), object.vertices[v]) != loop.end()) return std::nullopt;
    loop.push_back(object.vertices[v]);
  }
  try {
    return figure_part(loop, number);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // its triangles are figures
  }
}

void add_figures(const Object& object, const Surface& surface, std::uint32_t number, PartSet& set) {
  struct Side {
    std::uint32_t face;
    SeamSide at;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Side>> sides;
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    const SurfaceFace& face = surface.faces[f];
    Part part;
    part.kind = PartKind::kFigure;
    part.object = number;
    part.two_sided = !surface.closed;
    Loop corners;
    for (const std::uint32_t v : face.loop) {
      corners.push_back(static_cast<std::uint32_t>(part.vertices.size()));
      part.vertices.push_back(surface.vertices[v]);
    }
    part.faces.push_back({corners, face.plane, {}});
    connect_edges(part);
    const auto index = static_cast<std::uint32_t>(set.parts.size());
    for (std::size_t i = 0; i < face.loop.size(); ++i)
      sides[std::minmax(face.loop[i], face.loop[(i + 1) % face.loop.size()])].push_back(
          {f, {index, part.faces[0].edges[i]}});
    set.parts.push_back(std::move(part));
  }
  std::uint32_t edge_number = 0;
  for (const auto& [ends, faces] : sides) {
    const bool divided =
        faces.size() == 2 && one_face(object, surface, faces[0].face, faces[1].face);
    for (const Side& side : faces) {
      PartEdge& edge = set.parts[side.at.part].edges[side.at.edge];
      edge.number = edge_number;
      if (faces.size() > 1) edge.seam = static_cast<std::uint32_t>(set.seams.size());
      if (divided) edge.drawn = Drawn::kWhenExtreme;
    }
    if (faces.size() > 1) {
      auto& seam = set.seams.emplace_back();
      for (const Side& side : faces) seam.push_back(side.at);
    }
    ++edge_number;
  }
}

void add_object(const Object& object, std::uint32_t number, PartSet& set, Notices& notices) {
  const Surface surface = make_surface(object, notices);
  if (surface.faces.empty()) return;
  std::optional<Part> part;
  if (surface.convex) part = solid(object, surface, number);
  if (!surface.closed) part = plane_figure(object, number);
  if (part)
    set.parts.push_back(std::move(*part));
  else
    add_figures(object, surface, number, set);
}

void add_wire(const Object& object, std::uint32_t number, PartSet& set, Notices& notices) {
  Object used = object;
  for (Face& face : used.faces)
    face.vertices.erase(std::unique(face.vertices.begin(), face.vertices.end(),
                                    [&](std::uint32_t a, std::uint32_t b) {
                                      return used.vertices[a] == used.vertices[b];
                                    }),
                        face.vertices.end());
  Part part = wire_part(used, number);
  if (part.edges.empty())
    notices.add("wire frame without an edge");
  else
    set.parts.push_back(std::move(part));
}

}  // namespace

PartSet scene_parts(const Environment& environment, std::span<const Placement> placements,
                    std::span<const std::uint32_t> wires, Notices& notices) {
  PartSet set;
  for (std::uint32_t o = 0; o < environment.objects.size(); ++o) {
    const Object& object = environment.objects[o];
    if (!is_most_detailed(environment, object)) continue;
    const Object here = placed(object, placements[environment.models[object.model].system]);
    const bool wire = std::find(wires.begin(), wires.end(), o + 1) != wires.end();
    (wire ? add_wire : add_object)(here, o + 1, set, notices);
  }
  for (std::uint32_t g = 0; g < environment.ground.size(); ++g) {
    Object outline;
    outline.vertices = environment.ground[g].vertices;
    outline.faces.emplace_back();
    for (std::uint32_t v = 0; v < outline.vertices.size(); ++v)
      outline.faces[0].vertices.push_back(v);
    add_wire(outline, static_cast<std::uint32_t>(environment.objects.size()) + g + 1, set, notices);
    if (!set.parts.empty()) set.parts.back().marking = true;
  }
  return set;
}

std::vector<Plane> table_planes(const Environment& environment) {
  std::vector<Plane> planes;
  for (const SeparationPlane& plane : environment.separation) {
    const double square = dot(plane.normal, plane.normal);
    if (square > 0)
      planes.push_back(plane_with_normal(plane.normal * (plane.distance / square), plane.normal));
  }
  return planes;
}

}  // namespace cigsim::hidden_line
