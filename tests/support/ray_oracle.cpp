// SPDX-License-Identifier: MIT
#include "tests/support/ray_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cigsim::test {
namespace {

// The directions of the samples: d(c, r) = base + c * right + r * down, from the adjugate of the
// view matrix, which is its inverse but for a positive factor once its sign is taken out.
struct Rays {
  ExactVec base, right, down;
  Vec3 base_d, right_d, down_d;
};

Vec3 rounded(const ExactVec& v) { return {v.x.get_d(), v.y.get_d(), v.z.get_d()}; }

Rays make_rays(const ViewTransform& view) {
  const ExactVec u = convert<Exact>(view.rotation.row[0]), v = convert<Exact>(view.rotation.row[1]),
                 w = convert<Exact>(view.rotation.row[2]);
  const ExactVec cu = cross(v, w), cv = cross(w, u), cw = cross(u, v);
  const Exact sign = sgn(dot(u, cu)) > 0 ? 1 : -1;
  Rays rays;
  rays.right = cv * sign;
  rays.down = cw * Exact(-sign);
  const Exact half(0.5);
  const Exact c0(half - Exact(view.raster.width) * half),
      r0(half - Exact(view.raster.height) * half);
  rays.base = cu * Exact(sign * Exact(view.focal)) + rays.right * c0 + rays.down * r0;
  rays.base_d = rounded(rays.base);
  rays.right_d = rounded(rays.right);
  rays.down_d = rounded(rays.down);
  return rays;
}

// A polygon relative to the eyepoint. `edge[i]` is the normal of the plane through the eyepoint and
// edge i; a ray is inside when it lies on the same side of all of them.
struct Cone {
  std::uint32_t object = 0;
  std::vector<ExactVec> edges;
  std::vector<Vec3> edges_d;
  ExactVec normal;
  Exact offset;  // normal · (vertex - eye)
  Vec3 normal_d;
  double offset_d = 0;
  int facing = 0;  // +1: the eyepoint is in front
};

Cone make_cone(const OraclePolygon& polygon, const Vec3& eye) {
  Cone cone;
  cone.object = polygon.object;
  const ExactVec e = convert<Exact>(eye);
  std::vector<ExactVec> v;
  for (const Vec3& p : polygon.vertices) v.push_back(convert<Exact>(p) - e);
  for (std::size_t i = 0; i < v.size(); ++i) {
    cone.edges.push_back(cross(v[i], v[(i + 1) % v.size()]));
    cone.edges_d.push_back(rounded(cone.edges.back()));
  }
  for (std::size_t i = 2; i < v.size(); ++i) {
    const ExactVec n = cross(v[i - 1] - v[0], v[i] - v[0]);
    if (sgn(n.x) == 0 && sgn(n.y) == 0 && sgn(n.z) == 0) continue;
    cone.normal = n;
    break;
  }
  cone.offset = dot(cone.normal, v[0]);
  cone.normal_d = rounded(cone.normal);
  cone.offset_d = cone.offset.get_d();
  cone.facing = -sgn(cone.offset);
  return cone;
}

double magnitude(const Vec3& a, const Vec3& b) {
  return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}

ExactVec exact_ray(const Rays& rays, int c, int r) {
  return rays.base + rays.right * Exact(c) + rays.down * Exact(r);
}

// Sign of n · d(c, r), the sample moved a little right and then much less down.
int side_of_ray(const ExactVec& n, const Vec3& n_d, const Rays& rays, const Vec3& d, int c, int r) {
  const double value = dot(n_d, d);
  const double sum = magnitude(n_d, rays.base_d) + c * magnitude(n_d, rays.right_d) +
                     r * magnitude(n_d, rays.down_d);
  if (std::abs(value) > 1e-12 * sum) return value > 0 ? 1 : -1;
  if (const int s = sgn(dot(n, exact_ray(rays, c, r)))) return s;
  if (const int s = sgn(dot(n, rays.right))) return s;
  return sgn(dot(n, rays.down));
}

bool hit(const Cone& cone, const Rays& rays, const Vec3& d, int c, int r) {
  for (std::size_t i = 0; i < cone.edges.size(); ++i)
    // Seen from the front the polygon runs anticlockwise: the rays inside lie on the side of the
    // edge's normal that looks to the polygon.
    if (side_of_ray(cone.edges[i], cone.edges_d[i], rays, d, c, r) != -cone.facing) return false;
  // The cone behind the eyepoint has the other sign throughout, so the hit is ahead.
  return true;
}

// True when cone a is hit nearer than cone b by the sample moved a little right and then much less
// down: 1 / t is linear over the raster. Faces that stay level are not nearer than each other.
bool nearer_at(const Cone& a, const Cone& b, const Rays& rays, int c, int r) {
  for (const ExactVec& step : {exact_ray(rays, c, r), rays.right, rays.down}) {
    const Exact pa = dot(a.normal, step) / a.offset, pb = dot(b.normal, step) / b.offset;
    if (pa != pb) return pa > pb;
  }
  return false;
}

}  // namespace

std::vector<OraclePolygon> oracle_polygons(const Environment& environment, bool two_sided) {
  std::vector<OraclePolygon> polygons;
  for (std::uint32_t o = 0; o < environment.objects.size(); ++o)
    for (const Face& face : environment.objects[o].faces) {
      OraclePolygon p;
      p.object = o + 1;
      p.two_sided = two_sided;
      for (const std::uint32_t v : face.vertices)
        p.vertices.push_back(environment.objects[o].vertices[v]);
      polygons.push_back(std::move(p));
    }
  return polygons;
}

std::vector<std::uint16_t> cast_rays(const std::vector<OraclePolygon>& polygons,
                                     const ViewTransform& view) {
  const Rays rays = make_rays(view);
  std::vector<Cone> cones;
  for (const OraclePolygon& polygon : polygons) {
    Cone cone = make_cone(polygon, view.eye);
    if (cone.facing > 0 || (cone.facing < 0 && polygon.two_sided)) cones.push_back(std::move(cone));
  }
  std::vector<std::uint16_t> picture;
  for (int r = 0; r < view.raster.height; ++r) {
    for (int c = 0; c < view.raster.width; ++c) {
      const Vec3 d = rays.base_d + rays.right_d * c + rays.down_d * r;
      const Cone* nearest = nullptr;
      double nearest_t = 0;
      for (const Cone& cone : cones) {
        if (!hit(cone, rays, d, c, r)) continue;
        const double t = cone.offset_d / dot(cone.normal_d, d);
        bool nearer = nearest == nullptr || t < nearest_t;
        if (nearest != nullptr && !(std::abs(t - nearest_t) > 1e-6 * std::abs(nearest_t)))
          nearer = nearer_at(cone, *nearest, rays, c, r);
        if (!nearer) continue;
        nearest = &cone;
        nearest_t = t;
      }
      picture.push_back(static_cast<std::uint16_t>(nearest ? nearest->object : 0));
    }
  }
  return picture;
}

double distance_to_edge(const std::vector<OraclePolygon>& polygons, const ViewTransform& view,
                        int column, int row) {
  struct Point {
    double u, x, y;  // x, y times u
  };
  const double cx = column + 0.5 - view.raster.width / 2.0,
               cy = row + 0.5 - view.raster.height / 2.0;
  double best = std::numeric_limits<double>::infinity();
  for (const OraclePolygon& polygon : polygons)
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      Point p[2];
      for (int k = 0; k < 2; ++k) {
        const Vec3 v =
            view.rotation * (polygon.vertices[(i + k) % polygon.vertices.size()] - view.eye);
        p[k] = {v.x, view.focal * v.y, -view.focal * v.z};
      }
      const double tiny = 1e-9 * (std::abs(p[0].u) + std::abs(p[1].u));
      if (p[0].u <= tiny && p[1].u <= tiny) continue;
      for (int k = 0; k < 2; ++k)
        if (p[k].u <= tiny) {
          const double t = (tiny - p[k].u) / (p[1 - k].u - p[k].u);
          p[k] = {tiny, p[k].x + t * (p[1 - k].x - p[k].x), p[k].y + t * (p[1 - k].y - p[k].y)};
        }
      const double ax = p[0].x / p[0].u - cx, ay = p[0].y / p[0].u - cy;
      const double bx = p[1].x / p[1].u - cx, by = p[1].y / p[1].u - cy;
      const double dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
      const double t = length > 0 ? std::clamp(-(ax * dx + ay * dy) / length, 0.0, 1.0) : 0;
      best = std::min(best, std::hypot(ax + t * dx, ay + t * dy));
    }
  return best;
}

}  // namespace cigsim::test
