// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/separation_scene.hpp"

#include <algorithm>
#include <cmath>

#include "models/database/listability/whole_plane.hpp"

namespace cigsim::separation_planes {
namespace {

bool fits(const mpz_class& value) { return abs(value) <= mpz_class(1) << 53; }

SeparationPlane separation_plane(const ResultPlane& plane) {
  const listability::WholePlane whole = listability::whole_plane(plane.plane);
  if (fits(whole.n.x) && fits(whole.n.y) && fits(whole.n.z) && fits(whole.d))
    return {
        {whole.n.x.get_d(), whole.n.y.get_d(), whole.n.z.get_d()}, whole.d.get_d(), plane.pairs};
  const UnitPlane unit = unit_plane(plane.plane);
  return {unit.normal, unit.distance, plane.pairs};
}

Object part(const Object& whole, const Body& body, const char* side) {
  Object object = object_of(body, whole.name.empty() ? "" : whole.name + side);
  object.model = whole.model;
  // The parts have faces of their own; they keep the colour that the object has all over.
  const auto same = [&](const Face& f) { return f.colour == whole.faces.front().colour; };
  if (std::all_of(whole.faces.begin(), whole.faces.end(), same))
    for (Face& face : object.faces) face.colour = whole.faces.front().colour;
  return object;
}

}  // namespace

UnitPlane unit_plane(const Plane& plane) {
  const ExactVec n = exact_normal(plane);
  const Exact most = std::max({Exact(abs(n.x)), Exact(abs(n.y)), Exact(abs(n.z))});
  const auto scaled = [&](const Exact& c) { return Exact(c / most).get_d(); };
  const Vec3 near{scaled(n.x), scaled(n.y), scaled(n.z)};
  const double length = std::hypot(near.x, near.y, near.z);
  const Exact d = dot(n, convert<Exact>(plane.exact.p));
  // Adding 0 turns a negative zero into a positive one.
  return {{near.x / length + 0.0, near.y / length + 0.0, near.z / length + 0.0},
          scaled(d) / length + 0.0};
}

Environment with_table(Environment scene, const PublishedTable& table) {
  scene.separation.clear();
  for (const ChosenPlane& plane : table.planes)
    scene.separation.push_back({plane.plane.normal, plane.plane.distance, plane.pairs});
  return scene;
}

Environment with_table(Environment scene, const SeparationResult& result) {
  const std::vector<Object> whole = scene.objects;
  for (std::size_t b = 0; b < result.bodies.size(); ++b) {
    const Body& body = result.bodies[b];
    if (!body.part) continue;
    const bool first = b < whole.size();
    Object object = part(whole[body.object - 1], body, first ? "" : " (part)");
    if (first)
      scene.objects[b] = std::move(object);
    else
      scene.objects.push_back(std::move(object));
  }
  scene.separation.clear();
  for (const ResultPlane& plane : result.planes)
    scene.separation.push_back(separation_plane(plane));
  return scene;
}

}  // namespace cigsim::separation_planes
