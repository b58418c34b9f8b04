// SPDX-License-Identifier: MIT
#include "tests/support/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "models/numeric/plane.hpp"

namespace cigsim::test {
namespace {

Vec3 unit(const Vec3& v) { return v * (1 / std::sqrt(dot(v, v))); }

Vec3 turned(const Mat3& m, const Vec3& c, const Vec3& offset) { return c + m * offset; }

// The corners of the hull of coplanar points, anticlockwise about n: gift wrapping.
std::vector<std::uint32_t> wrap(const std::vector<Vec3>& points,
                                const std::vector<std::uint32_t>& set, const Vec3& tip) {
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = points[a], &q = points[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  const std::uint32_t first = *std::min_element(set.begin(), set.end(), before);
  std::vector<std::uint32_t> loop;
  std::uint32_t at = first;
  do {
    loop.push_back(at);
    std::uint32_t next = at == set[0] ? set[1] : set[0];
    for (const std::uint32_t p : set) {
      if (p == at || p == next) continue;
      // The tip lies in front; p to the right of at -> next takes its place, or beyond it.
      const int s = orientation(points[at], points[next], tip, points[p]);
      const bool beyond = s == 0 && (before(at, next) ? before(next, p) : before(p, next));
      if (s > 0 || beyond) next = p;
    }
    at = next;
  } while (at != first);
  return loop;
}

}  // namespace

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double square = dot(d, d);
    if (square < 1 && square > 0.01) return d * (1 / std::sqrt(square));
  }
}

Mat3 random_turn(Random& random) {
  const Vec3 x = random_direction(random);
  while (true) {
    const Vec3 side = cross(x, random_direction(random));
    if (dot(side, side) < 0.01) continue;
    const Vec3 y = unit(side);
    return {{x, y, cross(x, y)}};
  }
}

Object box_between(const Vec3& a, const Vec3& b) {
  Object o;
  for (int i = 0; i < 8; ++i)
    o.vertices.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
  for (const std::vector<std::uint32_t>& f : std::vector<std::vector<std::uint32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    o.faces.push_back({f, {}});
  return o;
}

Object exact_hull(const std::vector<Vec3>& points) {
  Object o;
  o.vertices = points;
  const auto n = static_cast<std::uint32_t>(points.size());
  std::set<std::vector<std::uint32_t>> seen;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 1; j < n; ++j)
      for (std::uint32_t k = j + 1; k < n; ++k) {
        if (collinear(points[i], points[j], points[k])) continue;
        std::vector<std::uint32_t> flat;
        int front = 0, back = 0;
        std::uint32_t inner = i;
        for (std::uint32_t m = 0; m < n && (front == 0 || back == 0); ++m) {
          const int s = orientation(points[i], points[j], points[k], points[m]);
          if (s == 0)
            flat.push_back(m);
          else
            inner = m;
          front += s > 0;
          back += s < 0;
        }
        if ((front > 0) == (back > 0)) continue;
        if (!seen.insert(flat).second) continue;
        // Seen from the body's inside the loop runs clockwise.
        std::vector<std::uint32_t> loop = wrap(points, flat, points[inner]);
        if (orientation(points[loop[0]], points[loop[1]], points[loop[2]], points[inner]) > 0)
          std::reverse(loop.begin(), loop.end());
        o.faces.push_back({loop, {}});
      }
  return o;
}

Object polygon(const std::vector<Vec3>& corners) {
  Object o;
  o.vertices = corners;
  Face face;
  for (std::uint32_t i = 0; i < corners.size(); ++i) face.vertices.push_back(i);
  o.faces.push_back(face);
  return o;
}

Object random_box(const Vec3& c, double r, Random& random) {
  const Mat3 m = random_turn(random);
  const double x = r * random.between(0.1, 0.57), y = r * random.between(0.1, 0.57),
               z = r * random.between(0.1, 0.57);
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(turned(m, c, {i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z}));
  return exact_hull(points);
}

Object random_prism(const Vec3& c, double r, Random& random) {
  const Mat3 m = random_turn(random);
  const std::uint32_t sides = 3 + random.below(4);
  const double width = r * random.between(0.2, 0.6), height = r * random.between(0.1, 0.6);
  std::vector<Vec3> points;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.between(0, 0.5)) / sides;
    for (const double h : {-height, height})
      points.push_back(turned(m, c, {width * std::cos(angle), width * std::sin(angle), h}));
  }
  return exact_hull(points);
}

Object random_tetrahedron(const Vec3& c, double r, Random& random) {
  while (true) {
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i) points.push_back(c + random_direction(random) * (0.99 * r));
    const Object o = exact_hull(points);
    if (o.faces.size() == 4) return o;
  }
}

Object random_hull(const Vec3& c, double r, Random& random) {
  const std::uint32_t count = 5 + random.below(6);
  std::vector<Vec3> points;
  for (std::uint32_t i = 0; i < count; ++i)
    points.push_back(c + random_direction(random) * (r * random.between(0.4, 0.99)));
  return exact_hull(points);
}

Object random_body(const Vec3& c, double r, Random& random) {
  switch (random.below(4)) {
    case 0:
      return random_box(c, r, random);
    case 1:
      return random_prism(c, r, random);
    case 2:
      return random_tetrahedron(c, r, random);
    default:
      return random_hull(c, r, random);
  }
}

}  // namespace cigsim::test
