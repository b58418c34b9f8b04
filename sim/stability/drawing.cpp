// SPDX-License-Identifier: MIT
#include "sim/stability/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "models/geometry_processor/functional_certified.hpp"
#include "models/geometry_processor/functional_words.hpp"
#include "models/machine/scale.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/shown_faces.hpp"

namespace cigsim::stability {
namespace {

Exact place_of(const MachineWord& word) { return Exact(to_double(word)); }
Exact place_of(const Exact& value) { return value; }
Exact place_of(double value) { return Exact(std::isfinite(value) ? value : 0); }

bool is_number(double value) { return std::isfinite(value); }
bool is_number(const MachineWord&) { return true; }
bool is_number(const Exact&) { return true; }

template <class N>
void take_edges(const EdgeList<N>& list, Drawing& out) {
  for (const RasterFace& face : list.faces) {
    const std::uint32_t triangle = face.object - 1;
    out.faces.push_back({triangle, face.first_line, face.end_line});
    for (std::uint32_t e = face.first_edge; e < face.first_edge + face.edge_count; ++e) {
      const Edge<N>& edge = list.edges[e];
      out.doubtful |= !is_number(edge.x) || !is_number(edge.slope);
      out.edges.push_back({triangle, edge.first_line, edge.end_line, edge.left, place_of(edge.x),
                           place_of(edge.slope)});
    }
  }
}

// What these decide is certain; where their edges lie is not told to more than that needs.
void take_edges(const EdgeList<Certified>& list, Drawing& out) {
  for (const RasterFace& face : list.faces)
    out.faces.push_back({face.object - 1, face.first_line, face.end_line});
}

template <class N>
std::vector<bool> shown(const FaceSet& set, const Vec3& eye) {
  // Certified sides are those of doubles.
  using Decider = std::conditional_t<std::is_same_v<N, Certified>, double, N>;
  std::vector<bool> out;
  for (const PreparedFace& face : set.faces) {
    const int facing = geometry_processor::Functional<Decider>::facing(set.planes[face.plane], eye);
    out.push_back(facing > 0 || (facing < 0 && face.two_sided));
  }
  return out;
}

template <class N>
Drawing draw_as(const Database& database, const ViewTransform& view) {
  const FaceSet& set = database.systems[0].set;
  const ItemRef item{SetId::kStatic, 0};
  EdgeList<N> edges;
  geometry_processor::Functional<N>().compute(view, {&set, &set, &set}, {&item, 1}, edges);
  Drawing out;
  edge_orderer::Functional<N>().compute(edges, view.raster, out.crossings);
  take_edges(edges, out);
  out.shown = shown<N>(set, view.eye);
  return out;
}

Drawing draw_in_words(const Database& database, const ViewTransform& view,
                      MachineDescription machine) {
  machine.raster = view.raster;
  machine.edge_capacity = machine.face_capacity = machine.crossing_capacity = 0;
  machine.vertex_capacity = machine.corner_capacity = 0;
  const int scale = coordinate_scale(database, machine.formats, largest_coordinate(view.eye));
  const geometry_processor::FaceMemory memory(database.systems[0].set, scale, machine), none;
  Drawing out;
  std::uint64_t overflows = memory.overflows();
  const geometry_processor::GeometryBank bank{view_words(view, scale, machine.formats, overflows),
                                              {&memory, &none, &none}};
  const ItemWord items[2] = {{SetId::kStatic, 0, false}, {SetId::kStatic, 0, true}};
  EdgeList<MachineWord> edges;
  geometry_processor::Figures figures;
  geometry_processor::FunctionalWords(machine).compute(bank, items, edges, figures);
  edge_orderer::Functional<MachineWord>().compute(edges, view.raster, out.crossings);
  take_edges(edges, out);
  out.shown = shown_faces(machine, bank, items[0]);
  out.doubtful = overflows + figures.overflows > 0;
  return out;
}

}  // namespace

Drawing::Cover Drawing::cover(std::uint32_t triangle, int line) const {
  // A convex face has one left and one right crossing on a line that it covers.
  Cover cover;
  bool begun = false;
  for (std::uint32_t c = crossings.first[static_cast<std::size_t>(line)];
       c < crossings.first[static_cast<std::size_t>(line) + 1]; ++c) {
    const Crossing& crossing = crossings.crossings[c];
    if (faces[crossing.face].triangle != triangle) continue;
    if (crossing.left && !begun) {
      cover.first = crossing.element;
      begun = true;
    } else if (!crossing.left && begun) {
      cover.end = crossing.element;
    }
  }
  return cover.end > cover.first ? cover : Cover{};
}

Database database_of(std::span<const Triangle> triangles, bool two_sided) {
  Database database;
  database.systems.resize(1);
  FaceSet& set = database.systems[0].set;
  Item item;
  for (const Triangle& t : triangles) {
    PreparedFace face;
    face.first_corner = static_cast<std::uint32_t>(set.corners.size());
    face.corner_count = 3;
    face.plane = static_cast<std::uint32_t>(set.planes.size());
    face.object = face.plane + 1;
    face.two_sided = two_sided;
    for (const Vec3& corner : t) {
      set.corners.push_back(static_cast<std::uint32_t>(set.vertices.size()));
      set.vertices.push_back(corner);
    }
    set.planes.push_back(plane_through(t[0], t[1], t[2]));
    set.faces.push_back(face);
  }
  item.face_count = static_cast<std::uint32_t>(set.faces.size());
  item.vertex_count = static_cast<std::uint32_t>(set.vertices.size());
  item.sphere.centre = set.vertices[0];
  for (const Vec3& vertex : set.vertices)
    item.sphere.radius = std::max(item.sphere.radius, length(vertex - item.sphere.centre));
  set.items.push_back(item);
  return database;
}

Drawing draw(std::span<const Triangle> triangles, bool two_sided, const ViewTransform& view,
             const Format& format) {
  return draw(database_of(triangles, two_sided), view, format);
}

Drawing draw(const Database& database, const ViewTransform& view, const Format& format) {
  switch (format.arithmetic) {
    case Arithmetic::kFloat:
      return draw_as<float>(database, view);
    case Arithmetic::kMachine:
      return draw_in_words(database, view, format.machine);
    case Arithmetic::kExact:
      return draw_as<Exact>(database, view);
    case Arithmetic::kCertified:
      return draw_as<Certified>(database, view);
    case Arithmetic::kDouble:
      break;
  }
  return draw_as<double>(database, view);
}

}  // namespace cigsim::stability
