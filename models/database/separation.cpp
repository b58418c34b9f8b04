// SPDX-License-Identifier: MIT
#include "models/database/separation.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

constexpr std::size_t kMostEdgePairs = 20000;
constexpr int kMostHullSteps = 100;

struct EdgeEnds {
  std::uint32_t from, to;
};

std::vector<EdgeEnds> edges_of(const WorkSet& set, const WorkItem& item) {
  std::vector<EdgeEnds> edges;
  for (std::uint32_t p = item.first_polygon; p < item.first_polygon + item.polygon_count; ++p) {
    const WorkPolygon& polygon = set.polygons[p];
    for (std::uint32_t c = 0; c < polygon.corner_count; ++c) {
      const std::uint32_t a = set.corners(polygon)[c],
                          b = set.corners(polygon)[(c + 1) % polygon.corner_count];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const EdgeEnds& x, const EdgeEnds& y) {
    return x.from != y.from ? x.from < y.from : x.to < y.to;
  });
  edges.erase(std::unique(edges.begin(), edges.end(),
                          [](const EdgeEnds& x, const EdgeEnds& y) {
                            return x.from == y.from && x.to == y.to;
                          }),
              edges.end());
  return edges;
}

std::vector<std::uint32_t> vertices_of(const std::vector<EdgeEnds>& edges) {
  std::vector<std::uint32_t> list;
  for (const EdgeEnds& e : edges) {
    list.push_back(e.from);
    list.push_back(e.to);
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

bool finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Of large coordinates a candidate may overflow.
bool finite(const PlaneDefinition& d) {
  return finite(d.p) && finite(d.u0) && finite(d.u1) && finite(d.v0) && finite(d.v1);
}

// The plane, turned so that a is on its positive side, when it separates.
std::optional<Plane> if_separates(const WorkSet& set, const Plane& plane, const WorkItem& a,
                                  const WorkItem& b, std::uint32_t face_plane = WorkSet::kNothing) {
  if (!finite(plane.exact)) return std::nullopt;
  const int sa = set.classify(plane, a, face_plane);
  if (sa == 2) return std::nullopt;
  const int sb = set.classify(plane, b, face_plane);
  if (sb == 2 || (sa == 0 && sb == 0) || sa * sb > 0) return std::nullopt;
  return sa > 0 || (sa == 0 && sb < 0) ? plane : reversed(plane);
}

std::optional<Plane> by_faces(const WorkSet& set, const WorkItem& a, const WorkItem& b) {
  for (const WorkItem* item : {&a, &b})
    for (std::uint32_t p = item->first_polygon; p < item->first_polygon + item->polygon_count; ++p)
      if (auto plane =
              if_separates(set, set.planes[set.polygons[p].plane], a, b, set.polygons[p].plane))
        return plane;
  return std::nullopt;
}

using Points = std::vector<Vec3>;

Points points_of(const WorkSet& set, const std::vector<EdgeEnds>& edges) {
  Points points;
  for (const std::uint32_t v : vertices_of(edges)) points.push_back(set.vertex(v));
  return points;
}

struct Reach {
  double low, high;
};

Reach reach(const Points& points, const Vec3& n) {
  Reach r{dot(n, points[0]), dot(n, points[0])};
  for (const Vec3& p : points) {
    const double d = dot(n, p);
    r.low = std::min(r.low, d);
    r.high = std::max(r.high, d);
  }
  return r;
}

// Rules out, in doubles, most directions along which the two overlap.
bool may_part(const Points& a, const Points& b, const Vec3& n) {
  const Reach ra = reach(a, n), rb = reach(b, n);
  const double overlap = std::min(ra.high, rb.high) - std::max(ra.low, rb.low);
  const double size = std::max(ra.high - ra.low, rb.high - rb.low);
  return !(overlap > 0x1p-12 * size);
}

std::optional<Plane> by_edges(const WorkSet& set, const std::vector<EdgeEnds>& ea,
                              const std::vector<EdgeEnds>& eb, const WorkItem& a,
                              const WorkItem& b) {
  if (ea.size() * eb.size() > kMostEdgePairs) return std::nullopt;
  const Points pa = points_of(set, ea), pb = points_of(set, eb);
  const auto usable = [&](const EdgeEnds& e) { return !set.exact(e.from) && !set.exact(e.to); };
  for (const EdgeEnds& x : ea) {
    if (!usable(x)) continue;
    const Vec3 along = set.vertex(x.to) - set.vertex(x.from);
    for (const EdgeEnds& y : eb) {
      if (!usable(y)) continue;
      const Vec3 n = cross(along, set.vertex(y.to) - set.vertex(y.from));
      if (n == Vec3{} || !may_part(pa, pb, n)) continue;
      for (const std::uint32_t p : {x.from, y.from}) {
        const Plane plane = make_plane({set.vertex(p), set.vertex(x.from), set.vertex(x.to),
                                        set.vertex(y.from), set.vertex(y.to)});
        if (auto found = if_separates(set, plane, a, b)) return found;
      }
    }
  }
  return std::nullopt;
}

Vec3 centre(const WorkSet& set, const std::vector<std::uint32_t>& list) {
  Vec3 sum{};
  for (const std::uint32_t v : list) sum = sum + set.vertex(v);
  return sum * (1.0 / static_cast<double>(list.size()));
}

std::uint32_t extreme(const WorkSet& set, const std::vector<std::uint32_t>& list, const Vec3& n) {
  return *std::max_element(list.begin(), list.end(), [&](std::uint32_t p, std::uint32_t q) {
    return dot(n, set.vertex(p)) < dot(n, set.vertex(q));
  });
}

// Walks towards the shortest vector between the hulls (Gilbert 1966) and tries the plane across it.
std::optional<Plane> by_hulls(const WorkSet& set, const std::vector<std::uint32_t>& va,
                              const std::vector<std::uint32_t>& vb, const WorkItem& a,
                              const WorkItem& b) {
  Vec3 gap = centre(set, va) - centre(set, vb);  // a point of hull a minus hull b
  for (int step = 0; step < kMostHullSteps; ++step) {
    const double length = std::max({std::abs(gap.x), std::abs(gap.y), std::abs(gap.z)});
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    const Vec3 n = gap * (1 / length);
    const std::uint32_t low = extreme(set, va, n * -1.0), high = extreme(set, vb, n);
    const Vec3 corner = set.vertex(low) - set.vertex(high);
    if (dot(n, corner) > 0) {
      const Vec3 middle = (set.vertex(low) + set.vertex(high)) * 0.5;
      if (auto found = if_separates(set, plane_with_normal(middle, n), a, b)) return found;
    }
    const Vec3 along = corner - gap;
    const double square = dot(along, along);
    if (!(square > 0)) return std::nullopt;
    const double t = std::clamp(-dot(gap, along) / square, 0.0, 1.0);
    if (t == 0) return std::nullopt;
    gap = gap + along * t;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Plane> separating_plane(const WorkSet& set, const WorkItem& a, const WorkItem& b) {
  if (auto plane = by_faces(set, a, b)) return plane;
  const std::vector<EdgeEnds> ea = edges_of(set, a), eb = edges_of(set, b);
  if (auto plane = by_edges(set, ea, eb, a, b)) return plane;
  return by_hulls(set, vertices_of(ea), vertices_of(eb), a, b);
}

}  // namespace cigsim
