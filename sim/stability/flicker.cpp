// SPDX-License-Identifier: MIT
#include "sim/stability/flicker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/database/prepare.hpp"
#include "models/machine/scale.hpp"
#include "sim/stability/envelope_worlds.hpp"
#include "sim/stability/frame_judge.hpp"
#include "sim/view.hpp"

namespace cigsim::stability {
namespace {

// Odd, so that the middle column and line of samples lie straight ahead.
constexpr Raster kRaster{65, 65};
constexpr double kFov = 60;
constexpr FlickerStep kSteps[] = {FlickerStep::kDouble, FlickerStep::kFloat, FlickerStep::kWord,
                                  FlickerStep::kHeading};

double& axis_of(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

double ulp(double value) {
  const double size = std::abs(value);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

// Straight across from a corner of the scene: it and the edges that run upright or level through it
// lie on samples. `axis` is the one to move along.
Viewpoint across_from_a_corner(const Database& database, const SearchWorld& world, Random& random,
                               int& axis) {
  const std::vector<Vec3>& vertices = database.systems[0].set.vertices;
  const Vec3 corner = vertices[random.below(vertices.size())];
  axis = random.below(2) == 0 ? 0 : 2;
  Viewpoint viewpoint;
  viewpoint.fov = kFov;
  viewpoint.eye.position = {corner.x, corner.y - world.radius * random.between(0.5, 2), corner.z};
  return viewpoint;
}

// In the plane of a face or a separation plane, but for rounding, and looking at the middle.
Viewpoint in_a_plane(const Database& database, const SearchWorld& world, Random& random,
                     int& axis) {
  const PreparedSystem& system = database.systems[0];
  const auto& planes = system.hierarchy.planes.empty() || random.below(2) == 0
                           ? system.set.planes
                           : system.hierarchy.planes;
  const Plane& plane = planes[random.below(planes.size())];
  const double square = dot(plane.normal, plane.normal);
  const Vec3 from =
      world.centre +
      Vec3{random.between(-1, 1), random.between(-2, -1), random.between(0, 1)} * world.radius;
  const Vec3 eye = from - plane.normal * (dot(plane.normal, from - plane.exact.p) / square);
  Viewpoint viewpoint;
  viewpoint.fov = kFov;
  viewpoint.eye = eye == world.centre ? Placement{eye, 0, 0, 0} : look_at(eye, world.centre);
  const Vec3 size{std::abs(plane.normal.x), std::abs(plane.normal.y), std::abs(plane.normal.z)};
  axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return viewpoint;
}

double step_size(const Database& database, FlickerStep step, double at, double reach) {
  switch (step) {
    case FlickerStep::kDouble:
      return ulp(at != 0 ? at : 1);
    case FlickerStep::kFloat:
      return std::ldexp(ulp(at != 0 ? at : 1), 29);
    case FlickerStep::kWord: {
      const WordFormats widest;
      return std::ldexp(1, -coordinate_scale(database, widest, reach));
    }
    case FlickerStep::kHeading:
      break;
  }
  return ulp(1);  // of a degree
}

std::vector<FrameView> path_of(const Database& database, const SearchWorld& world, FlickerStep step,
                               int frames, Random& random) {
  int axis = 0;
  Viewpoint viewpoint = random.below(2) == 0 ? across_from_a_corner(database, world, random, axis)
                                             : in_a_plane(database, world, random, axis);
  const double reach = eye_reach({{viewpoint, 0}});
  const double at = axis_of(viewpoint.eye.position, axis), heading = viewpoint.eye.heading;
  const double size = step_size(database, step, at, reach);
  std::vector<FrameView> views;
  for (int k = 0; k < frames; ++k) {
    const double moved = size * (k - frames / 2);
    if (step == FlickerStep::kHeading)
      viewpoint.eye.heading = heading + moved;
    else
      axis_of(viewpoint.eye.position, axis) = at + moved;
    views.push_back({viewpoint, 0});
  }
  return views;
}

using Numbers = std::vector<std::uint16_t>;

std::vector<Numbers> pictures(const Database& database, const Format& format,
                              const std::vector<FrameView>& views) {
  FunctionalMachine machine(database, options_for(format, kRaster, eye_reach(views)));
  std::vector<Numbers> out;
  for (const FrameView& view : views)
    out.push_back(machine.compute(view.viewpoint, view.position).numbers);
  return out;
}

void compare(const std::vector<Numbers>& exact, const std::vector<Numbers>& got, Flicker& result) {
  for (std::size_t k = 0; k < exact.size(); ++k) {
    std::uint64_t flickering = 0;
    for (std::size_t i = 0; i < exact[k].size(); ++i) {
      result.wrong += got[k][i] != exact[k][i];
      if (k == 0) continue;
      const bool right = exact[k][i] != exact[k - 1][i];
      result.exact_changes += right;
      flickering += !right && got[k][i] != got[k - 1][i];
    }
    if (k == 0) continue;
    ++result.pairs;
    result.flickering += flickering;
    result.flickering_pairs += flickering > 0;
    result.worst = std::max(result.worst, flickering);
  }
}

}  // namespace

std::string_view name_of(FlickerStep step) {
  switch (step) {
    case FlickerStep::kDouble:
      return "double";
    case FlickerStep::kFloat:
      return "float";
    case FlickerStep::kWord:
      return "word";
    case FlickerStep::kHeading:
      break;
  }
  return "heading";
}

std::vector<Flicker> measure_flicker(const FlickerOptions& options) {
  const std::vector<SearchWorld> worlds = search_worlds(options.seed, false);
  std::vector<Database> databases;
  for (const SearchWorld& world : worlds) databases.push_back(prepare(world.environment));
  std::vector<Flicker> results;
  double done = 0;
  for (const FlickerStep step : kSteps) {
    const std::size_t first = results.size();
    for (const Format& format : options.formats) results.push_back({format, step});
    Random random(options.seed + 1 + static_cast<std::uint64_t>(step));
    for (int p = 0; p < options.paths; ++p) {
      const auto w = static_cast<std::size_t>(p) % worlds.size();
      const std::vector<FrameView> views =
          path_of(databases[w], worlds[w], step, options.frames, random);
      const Format exact{"exact", Arithmetic::kExact, {}};
      const std::vector<Numbers> right = pictures(databases[w], exact, views);
      for (std::size_t f = 0; f < options.formats.size(); ++f)
        compare(right, pictures(databases[w], options.formats[f], views), results[first + f]);
      done +=
          1.0 / static_cast<double>(std::size(kSteps) * static_cast<std::size_t>(options.paths));
      if (options.progress) options.progress(done);
    }
  }
  return results;
}

}  // namespace cigsim::stability
