// SPDX-License-Identifier: MIT
#include "models/database/bsp/polygons.hpp"

#include "models/database/notices.hpp"
#include "models/database/shade.hpp"
#include "models/database/surface.hpp"
#include "models/environment/placement.hpp"

namespace cigsim {
namespace {

void add_object(BspPolygons& out, const Object& object, std::uint32_t number, Notices& notices) {
  const Surface surface = make_surface(object, notices);
  const auto base = static_cast<std::uint32_t>(out.set.vertex_count());
  for (const Vec3& v : surface.vertices) out.set.add_vertex(v);
  Loop corners;
  for (const SurfaceFace& face : surface.faces) {
    corners = face.loop;
    for (std::uint32_t& c : corners) c += base;
    const auto order = static_cast<std::uint32_t>(out.set.polygons.size());
    out.set.add_polygon(
        corners, out.set.add_plane(face.plane),
        {number, order, object.faces[face.source].colour.value_or(palette_colour(number)),
         !surface.closed});
    out.set.add_item(1);
    out.body.push_back(surface.convex ? number : BspPolygons::kNoBody);
  }
}

}  // namespace

BspPolygons bsp_polygons(const Environment& environment) {
  BspPolygons out;
  Notices notices;
  for (std::uint32_t o = 0; o < environment.objects.size(); ++o) {
    const Object& object = environment.objects[o];
    const CoordinateSystem& system = environment.systems[environment.models[object.model].system];
    if (!system.motion.empty()) {
      ++out.moving_objects;
      continue;
    }
    out.faces += object.faces.size();
    add_object(out, placed(object, system.placement), o + 1, notices);
  }
  out.notices = notices.list();
  return out;
}

}  // namespace cigsim
