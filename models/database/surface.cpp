// SPDX-License-Identifier: MIT
#include "models/database/surface.hpp"

#include <algorithm>
#include <numeric>

#include "models/database/winding.hpp"

namespace cigsim {
namespace {

// New index of each vertex; equal coordinates share one (0 and -0 are equal).
std::vector<std::uint32_t> merge_vertices(const std::vector<Vec3>& input, std::vector<Vec3>& out) {
  std::vector<std::uint32_t> order(input.size()), index(input.size());
  std::iota(order.begin(), order.end(), 0);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = input[a], &q = input[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return a < b;
  };
  std::sort(order.begin(), order.end(), less);
  // The first of equal vertices stands for all, and the input order stays.
  std::vector<std::uint32_t> first(input.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] =
        i > 0 && input[order[i]] == input[order[i - 1]] ? first[order[i - 1]] : order[i];
  for (std::uint32_t v = 0; v < input.size(); ++v) {
    if (first[v] == v) {
      index[v] = static_cast<std::uint32_t>(out.size());
      out.push_back(input[v]);
    } else {
      index[v] = index[first[v]];
    }
  }
  return index;
}

Loop without_repeats(const Loop& loop) {
  Loop out;
  for (const std::uint32_t v : loop)
    if (out.empty() || out.back() != v) out.push_back(v);
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

// Removes corners where the loop turns back on itself (a, b, a).
void remove_spikes(Loop& loop) {
  for (std::size_t i = 0; loop.size() >= 3 && i < loop.size();) {
    const std::size_t n = loop.size();
    if (loop[(i + n - 1) % n] == loop[(i + 1) % n]) {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
      loop = without_repeats(loop);
      i = 0;
    } else {
      ++i;
    }
  }
}

// Keeps the first of faces with the same vertices in the same cyclic order.
std::vector<std::size_t> first_of_equal(const std::vector<Loop>& loops) {
  std::vector<Loop> canonical = loops;
  for (Loop& loop : canonical)
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return canonical[a] < canonical[b]; });
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (i == 0 || canonical[order[i]] != canonical[order[i - 1]]) kept.push_back(order[i]);
  std::sort(kept.begin(), kept.end());
  return kept;
}

struct Faces {
  std::vector<Loop> loops;
  std::vector<std::uint32_t> source;
};

Faces clean_faces(const Object& object, const std::vector<Vec3>& vertices,
                  const std::vector<std::uint32_t>& index, Notices& notices) {
  Faces faces;
  for (std::uint32_t f = 0; f < object.faces.size(); ++f) {
    Loop loop;
    for (const std::uint32_t v : object.faces[f].vertices) loop.push_back(index[v]);
    loop = without_repeats(loop);
    remove_spikes(loop);
    if (loop.size() < 3 || !FlatLoop::make(vertices, loop)) {
      notices.add("face without area dropped");
      continue;
    }
    faces.loops.push_back(std::move(loop));
    faces.source.push_back(f);
  }
  const std::vector<std::size_t> kept = first_of_equal(faces.loops);
  if (kept.size() < faces.loops.size()) {
    notices.add("duplicate face dropped", faces.loops.size() - kept.size());
    Faces unique;
    for (const std::size_t k : kept) {
      unique.loops.push_back(std::move(faces.loops[k]));
      unique.source.push_back(faces.source[k]);
    }
    return unique;
  }
  return faces;
}

void add_face(Surface& surface, Loop loop, std::uint32_t source) {
  const auto corners = spanning_corners(surface.vertices, loop);
  if (!corners) return;
  const auto [a, b, c] = *corners;
  Plane plane = plane_through(surface.vertices[a], surface.vertices[b], surface.vertices[c]);
  surface.faces.push_back({std::move(loop), plane, source});
}

// One input face as planar convex faces.
void add_planar_faces(Surface& surface, const Loop& loop, std::uint32_t source, Notices& notices) {
  const auto flat = FlatLoop::make(surface.vertices, loop);
  if (!flat) return;
  const auto corners = spanning_corners(surface.vertices, loop);
  const bool planar =
      loop.size() == 3 || (corners && on_plane(plane_through(surface.vertices[(*corners)[0]],
                                                             surface.vertices[(*corners)[1]],
                                                             surface.vertices[(*corners)[2]]),
                                               surface.vertices, loop));
  const bool convex = is_convex(*flat, loop);
  if (planar && convex) {
    add_face(surface, loop, source);
    return;
  }
  std::vector<Loop> pieces;
  if (!planar && convex && surface.closed) {
    notices.add("face not planar: made into triangles");
    pieces = bulge(surface.vertices, loop);
  } else {
    Triangulation t = triangulate(*flat, loop);
    notices.add(t.crossing ? "face crosses itself: made into triangles"
                : planar   ? "concave face: made into convex ones"
                           : "face not planar: made into triangles");
    pieces =
        planar && !t.crossing ? join_convex(*flat, std::move(t.triangles)) : std::move(t.triangles);
  }
  for (Loop& piece : pieces) add_face(surface, std::move(piece), source);
}

// Faces times vertices up to which convexity is examined.
constexpr double kMostConvexityTests = 1e9;

bool is_convex_body(const Surface& surface) {
  if (static_cast<double>(surface.faces.size()) * static_cast<double>(surface.vertices.size()) >
      kMostConvexityTests)
    return false;
  std::vector<char> used(surface.vertices.size(), 0);
  for (const SurfaceFace& face : surface.faces)
    for (const std::uint32_t v : face.loop) used[v] = 1;
  for (const SurfaceFace& face : surface.faces)
    for (std::uint32_t v = 0; v < surface.vertices.size(); ++v) {
      if (!used[v] || std::find(face.loop.begin(), face.loop.end(), v) != face.loop.end()) continue;
      if (side(face.plane, surface.vertices[v]) > 0) return false;
    }
  return true;
}

// Faces up to which a convex body is searched for coplanar ones.
constexpr std::size_t kMostFacesToJoin = 2000;

// On a convex body coplanar faces that share edges and a colour are one face of the body, whichever
// way the input divides it.
void join_coplanar_faces(Surface& surface, const Object& object, Notices& notices) {
  if (surface.faces.size() > kMostFacesToJoin) return;
  std::vector<SurfaceFace> joined;
  std::vector<char> taken(surface.faces.size(), 0);
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    if (taken[i]) continue;
    const SurfaceFace& first = surface.faces[i];
    std::vector<Loop> loops{first.loop};
    for (std::size_t j = i + 1; j < surface.faces.size(); ++j) {
      const SurfaceFace& other = surface.faces[j];
      if (taken[j] || object.faces[first.source].colour != object.faces[other.source].colour ||
          !(dot(first.plane.normal, other.plane.normal) > 0) ||
          !on_plane(first.plane, surface.vertices, other.loop))
        continue;
      loops.push_back(other.loop);
      taken[j] = 1;
    }
    if (loops.size() > 1) {
      const std::size_t before = loops.size();
      const auto flat = FlatLoop::make(surface.vertices, first.loop);
      loops = join_convex(*flat, std::move(loops));
      notices.add("coplanar face of a convex object: joined to its neighbour",
                  before - loops.size());
    }
    for (Loop& loop : loops) joined.push_back({std::move(loop), first.plane, first.source});
  }
  surface.faces = std::move(joined);
}

}  // namespace

Surface make_surface(const Object& object, Notices& notices) {
  Surface surface;
  const std::vector<std::uint32_t> index = merge_vertices(object.vertices, surface.vertices);
  notices.add("vertex at the place of another: merged",
              object.vertices.size() - surface.vertices.size());
  Faces faces = clean_faces(object, surface.vertices, index, notices);
  const WindingResult winding = repair_winding(surface.vertices, faces.loops);
  notices.add("vertex put into an edge that it lies on (T-junction)", winding.inserted);
  notices.add("face turned to face outwards", winding.turned_faces);
  surface.closed = winding.closed && !faces.loops.empty();
  for (std::size_t f = 0; f < faces.loops.size(); ++f)
    add_planar_faces(surface, faces.loops[f], faces.source[f], notices);
  if (surface.faces.empty())
    notices.add("object without a face that has area");
  else if (!surface.closed)
    notices.add("object not closed: seen from both sides");
  surface.convex = surface.closed && winding.parts == 1 && is_convex_body(surface);
  if (surface.convex) join_coplanar_faces(surface, object, notices);
  return surface;
}

}  // namespace cigsim
