// SPDX-License-Identifier: MIT
#include "models/database/bsp/polygons.hpp"

#include "models/database/notices.hpp"
#include "models/database/shade.hpp"
#include "models/database/surface_polygons.hpp"
#include "models/environment/placement.hpp"

namespace cigsim {
namespace {

void add_object(BspPolygons& out, const Object& object, std::uint32_t number, Notices& notices) {
  const Surface surface = make_surface(object, notices);
  add_faces(
      out.set, surface,
      [&](const SurfaceFace& face) -> FaceOrigin {
        const auto order = static_cast<std::uint32_t>(out.set.polygons.size());
        const Colour colour = object.faces[face.source].colour.value_or(palette_colour(number));
        return {number, order, colour, !surface.closed};
      },
      [&] {
        out.set.add_item(1);
        out.body.push_back(surface.convex ? number : BspPolygons::kNoBody);
      });
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
