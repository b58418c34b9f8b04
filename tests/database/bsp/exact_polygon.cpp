// SPDX-License-Identifier: MIT
#include "tests/database/bsp/exact_polygon.hpp"

namespace cigsim::test {

ExactLoop exact_loop(const WorkSet& set, std::uint32_t item) {
  const WorkPolygon& polygon = set.polygons[set.items[item].first_polygon];
  ExactLoop loop;
  for (std::uint32_t c = 0; c < polygon.corner_count; ++c) {
    const std::uint32_t v = set.corners(polygon)[c];
    loop.push_back(set.exact(v) ? *set.exact(v) : convert<Exact>(set.vertex(v)));
  }
  return loop;
}

ExactVec area_vector(const ExactLoop& loop) {
  ExactVec sum;
  for (std::size_t i = 2; i < loop.size(); ++i)
    sum = sum + cross(loop[i - 1] - loop[0], loop[i] - loop[0]);
  return sum;
}

int side_of_loop(const Plane& plane, const ExactLoop& loop) {
  const PlaneDefinition& d = plane.exact;
  const ExactVec normal = cross(convert<Exact>(d.u1) - convert<Exact>(d.u0),
                                convert<Exact>(d.v1) - convert<Exact>(d.v0));
  bool front = false, back = false;
  for (const ExactVec& v : loop) {
    const int s = sgn(dot(normal, v - convert<Exact>(d.p)));
    front = front || s > 0;
    back = back || s < 0;
  }
  return front && back ? 2 : front ? 1 : back ? -1 : 0;
}

std::optional<Exact> hit(const ExactLoop& loop, const ExactVec& eye, const ExactVec& d) {
  const ExactVec normal = area_vector(loop);
  const Exact slope = dot(normal, d);
  if (slope == 0) return std::nullopt;
  const Exact t = Exact(dot(normal, loop[0] - eye) / slope);
  if (t <= 0) return std::nullopt;
  const ExactVec at = eye + d * t;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ExactVec edge = loop[(i + 1) % loop.size()] - loop[i];
    if (dot(normal, cross(edge, at - loop[i])) < 0) return std::nullopt;
  }
  return t;
}

BspPolygons polygons_of(const std::vector<std::vector<Vec3>>& loops) {
  BspPolygons out;
  for (const std::vector<Vec3>& loop : loops) {
    std::vector<std::uint32_t> corners;
    for (const Vec3& v : loop) corners.push_back(out.set.add_vertex(v));
    const auto order = static_cast<std::uint32_t>(out.set.polygons.size());
    const std::uint32_t plane = out.set.add_plane(plane_through(loop[0], loop[1], loop[2]));
    out.set.add_polygon(corners, plane, {order + 1, order, {}, true});
    out.set.add_item(1);
    out.body.push_back(BspPolygons::kNoBody);
  }
  return out;
}

}  // namespace cigsim::test
