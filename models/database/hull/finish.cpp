// SPDX-License-Identifier: MIT
#include "models/database/hull/finish.hpp"

#include <algorithm>
#include <numeric>

namespace cigsim {
namespace {

constexpr std::uint32_t kNone = Polyhedron::kNone;

TriangleMesh mesh_of(const Polyhedron& polyhedron) {
  std::vector<std::uint32_t> number(polyhedron.face_places(), kNone);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < number.size(); ++i)
    if (polyhedron.face(i).alive) number[i] = count++;
  TriangleMesh mesh;
  mesh.triangles.reserve(count);
  mesh.neighbours.reserve(count);
  for (std::uint32_t i = 0; i < number.size(); ++i) {
    const Polyhedron::Face& face = polyhedron.face(i);
    if (!face.alive) continue;
    mesh.triangles.push_back(face.corner);
    mesh.neighbours.push_back(
        {number[face.neighbour[0]], number[face.neighbour[1]], number[face.neighbour[2]]});
  }
  return mesh;
}

// The corner of `triangle` that is not on its edge towards `across`.
std::uint32_t corner_beyond(const TriangleMesh& mesh, std::uint32_t triangle,
                            std::uint32_t across) {
  const auto& n = mesh.neighbours[triangle];
  const std::size_t edge = n[0] == across ? 0 : n[1] == across ? 1 : 2;
  return mesh.triangles[triangle][(edge + 2) % 3];
}

// For each triangle the smallest number among those of its facet. Empty: no two are coplanar.
std::vector<std::uint32_t> facets_of(const ExactPoints& points, const TriangleMesh& mesh) {
  std::vector<std::uint32_t> facet;
  const auto root = [&](std::uint32_t i) {
    while (facet[i] != i) i = facet[i] = facet[facet[i]];
    return i;
  };
  std::uint64_t exact = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const HullTriangle& t = mesh.triangles[i];
    const FilterPlane plane = points.plane(t[0], t[1], t[2]);
    for (const std::uint32_t across : mesh.neighbours[i]) {
      if (across < i) continue;
      const std::uint32_t corner = corner_beyond(mesh, across, i);
      if (plane.value(points.scaled(corner)) < -plane.bound ||
          points.side(t[0], t[1], t[2], corner, exact) != 0)
        continue;
      if (facet.empty()) {
        facet.resize(mesh.triangles.size());
        std::iota(facet.begin(), facet.end(), 0u);
      }
      const std::uint32_t a = root(i), b = root(across);
      facet[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::uint32_t i = 0; i < facet.size(); ++i) facet[i] = root(i);
  return facet;
}

std::vector<std::uint32_t> without_straight_corners(const ExactPoints& points,
                                                    const std::vector<std::uint32_t>& loop) {
  std::vector<std::uint32_t> out;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!points.collinear(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]))
      out.push_back(loop[i]);
  std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
  return out;
}

// The triangles of each facet one after another, facets in the order of their first triangles.
std::vector<std::uint32_t> by_facet(const std::vector<std::uint32_t>& facet) {
  std::vector<std::uint32_t> order(facet.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return facet[a] < facet[b]; });
  return order;
}

// Edges of one facet that lead to another, joined to the loop round it. `next` is by corner.
std::vector<std::uint32_t> loop_round(const TriangleMesh& mesh,
                                      const std::vector<std::uint32_t>& facet,
                                      std::span<const std::uint32_t> triangles,
                                      std::vector<std::uint32_t>& next) {
  std::uint32_t first = kNone;
  for (const std::uint32_t i : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      if (facet[mesh.neighbours[i][k]] == facet[i]) continue;
      first = mesh.triangles[i][k];
      next[first] = mesh.triangles[i][(k + 1) % 3];
    }
  std::vector<std::uint32_t> loop;
  for (std::uint32_t v = first; loop.empty() || v != first; v = next[v]) loop.push_back(v);
  return loop;
}

std::vector<std::vector<std::uint32_t>> merged_loops(const ExactPoints& points,
                                                     const TriangleMesh& mesh,
                                                     const std::vector<std::uint32_t>& facet) {
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::uint32_t> next(points.size(), kNone);
  const std::vector<std::uint32_t> order = by_facet(facet);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && facet[order[end]] == facet[order[begin]]) ++end;
    loops.push_back(without_straight_corners(
        points, loop_round(mesh, facet, std::span(order).subspan(begin, end - begin), next)));
  }
  return loops;
}

std::vector<HullTriangle> fans(const std::vector<std::vector<std::uint32_t>>& loops) {
  std::vector<HullTriangle> triangles;
  for (const auto& loop : loops)
    for (std::size_t i = 2; i < loop.size(); ++i)
      triangles.push_back({loop[0], loop[i - 1], loop[i]});
  return triangles;
}

std::vector<std::uint32_t> corners_of(const std::vector<HullTriangle>& triangles,
                                      std::size_t points) {
  std::vector<bool> used(points);
  for (const HullTriangle& t : triangles)
    for (const std::uint32_t corner : t) used[corner] = true;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < points; ++i)
    if (used[i]) corners.push_back(i);
  return corners;
}

}  // namespace

TriangleMesh mesh_of(std::vector<HullTriangle> triangles) {
  struct Edge {
    std::uint32_t low, high, triangle, place;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[i][k], triangles[i][(k + 1) % 3]);
      edges.push_back({low, high, i, k});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  TriangleMesh mesh{std::move(triangles), {}};
  mesh.neighbours.resize(mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    mesh.neighbours[edges[i].triangle][edges[i].place] = edges[i + 1].triangle;
    mesh.neighbours[edges[i + 1].triangle][edges[i + 1].place] = edges[i].triangle;
  }
  return mesh;
}

std::vector<std::vector<std::uint32_t>> facet_loops(const ExactPoints& points,
                                                    const TriangleMesh& mesh) {
  std::vector<std::uint32_t> facet = facets_of(points, mesh);
  if (facet.empty()) {
    facet.resize(mesh.triangles.size());
    std::iota(facet.begin(), facet.end(), 0u);
  }
  return merged_loops(points, mesh, facet);
}

Hull finish_hull(const Polyhedron& polyhedron, const HullCounters& counters) {
  const ExactPoints& points = polyhedron.points();
  TriangleMesh mesh = mesh_of(polyhedron);
  Hull hull;
  hull.dimension = 3;
  hull.counters = counters;
  hull.counters.faces = mesh.triangles.size();
  const std::vector<std::uint32_t> facet = facets_of(points, mesh);
  hull.triangles =
      facet.empty() ? std::move(mesh.triangles) : fans(merged_loops(points, mesh, facet));
  hull.vertices = corners_of(hull.triangles, points.size());
  return hull;
}

std::vector<std::vector<std::uint32_t>> hull_facets(std::span<const Vec3> points,
                                                    const Hull& hull) {
  if (hull.dimension < 2) return {};
  if (hull.dimension == 2) return {hull.vertices};
  return facet_loops(ExactPoints(points), mesh_of(hull.triangles));
}

}  // namespace cigsim
