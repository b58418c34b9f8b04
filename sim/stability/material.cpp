// SPDX-License-Identifier: MIT
#include "sim/stability/material.hpp"

#include <algorithm>
#include <cmath>

#include "models/database/polygon.hpp"

namespace cigsim::stability {
namespace {

// The faces of an item as triangles, and its vertices as a body.
void add_item(const FaceSet& set, const Item& item, Material& out) {
  const std::span<const Vec3> vertices(set.vertices.data() + item.first_vertex, item.vertex_count);
  for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
    const PreparedFace& face = set.faces[f];
    const auto corners = set.corners.begin() + face.first_corner;
    const Loop loop(corners, corners + face.corner_count);
    if (const auto three = spanning_corners(vertices, loop))
      out.triangles.push_back(
          {vertices[(*three)[0]], vertices[(*three)[1]], vertices[(*three)[2]]});
  }
  if (vertices.size() >= 4) out.bodies.emplace_back(vertices.begin(), vertices.end());
  if (item.face_count > 0) out.spheres.push_back(item.sphere);
}

}  // namespace

Material material_of(const Database& database, const std::vector<Vec3>& eyepoints) {
  Material out;
  if (!database.systems.empty()) {
    const PreparedSystem& environment = database.systems[0];
    for (const Item& item : environment.set.items) add_item(environment.set, item, out);
    for (const Plane& plane : environment.hierarchy.planes) out.planes.push_back(plane.exact);
    for (const Plane& plane : environment.set.planes) out.planes.push_back(plane.exact);
    for (const Member& member : environment.hierarchy.members)
      if (member.is_group) out.spheres.push_back(member.sphere);
  }
  for (const Item& item : database.ground.items) add_item(database.ground, item, out);
  out.eyepoints = eyepoints;
  out.eyepoints.push_back(database.view.eye.position);
  return out;
}

double reach_of(const Material& material) {
  double most = 0;
  const auto take = [&](const Vec3& p) {
    most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  for (const Triangle& t : material.triangles) std::for_each(t.begin(), t.end(), take);
  for (const PlaneDefinition& d : material.planes)
    for (const Vec3& p : {d.p, d.u0, d.u1, d.v0, d.v1}) take(p);
  for (const std::vector<Vec3>& body : material.bodies)
    std::for_each(body.begin(), body.end(), take);
  for (const Sphere& sphere : material.spheres) {
    take(sphere.centre);
    most = std::max(most, sphere.radius);
  }
  for (const Vec3& eye : material.eyepoints) take(eye);
  return most;
}

}  // namespace cigsim::stability
