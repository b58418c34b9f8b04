// SPDX-License-Identifier: MIT
#include "sim/stability/envelope_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/priority_processor/functional.hpp"
#include "sim/embedded.hpp"
#include "sim/functional_machine.hpp"
#include "sim/stability/directions.hpp"

namespace cigsim::stability {
namespace {

constexpr int kObjects = 12;
constexpr Raster kRaster{64, 64};
// Few elements over a wide field: what is near is then told from what is fine.
constexpr Raster kCoarseRaster{16, 16};
constexpr double kFov = 60, kWideFov = 140;
constexpr int kTries = 12;  // viewpoints looked at for one that is clear of all planes

SearchWorld bounded(std::string name, Environment environment) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const Object& object : environment.objects) {
    if (environment.models[object.model].system != 0) continue;
    for (const Vec3& v : object.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  }
  const Vec3 half = (high - low) * 0.5;
  return {std::move(name), std::move(environment), low + half, length(half)};
}

// Where look_at has no answer the eye keeps its attitude.
Viewpoint looking(const Vec3& eye, const Vec3& target, double fov) {
  Viewpoint viewpoint{{eye, 0, 0, 0}, fov};
  if (!(eye == target)) viewpoint.eye = look_at(eye, target);
  return viewpoint;
}

}  // namespace

std::string_view name_of(SearchAxis axis) {
  switch (axis) {
    case SearchAxis::kRaster:
      return "raster";
    case SearchAxis::kClearance:
      return "clearance";
    case SearchAxis::kSmall:
      return "scale-down";
    case SearchAxis::kLarge:
      return "scale-up";
    case SearchAxis::kOffset:
      return "offset";
    case SearchAxis::kFar:
      return "far";
    case SearchAxis::kNear:
      break;
  }
  return "near";
}

Steps steps_of(SearchAxis axis) {
  switch (axis) {
    case SearchAxis::kRaster:
      return {4, 14, 1};
    case SearchAxis::kClearance:
      return {8, 44, 1};
    case SearchAxis::kSmall:
    case SearchAxis::kLarge:
      return {2, 60, 2};
    case SearchAxis::kOffset:
      return {0, 36, 1};
    case SearchAxis::kFar:
      return {1, 38, 1};
    case SearchAxis::kNear:
      break;
  }
  return {3, 36, 1};
}

std::vector<SearchWorld> search_worlds(std::uint64_t seed, bool airfield) {
  std::vector<SearchWorld> worlds;
  for (const char* kind : {"random", "brushes", "city"})
    worlds.push_back(bounded(kind, generate_environment(kind, {kObjects, seed})));
  if (airfield) {
    const auto text = embedded_text(embedded_scenes(), "airfield.json");
    worlds.push_back(bounded("airfield", parse_json(text, "airfield").environment));
  }
  return worlds;
}

SearchWorld moved(const SearchWorld& world, double scale, const Vec3& offset) {
  SearchWorld out = world;
  const auto move = [&](Vec3& p) { p = p * scale + offset; };
  for (Object& object : out.environment.objects) {
    const bool own = out.environment.models[object.model].system == 0;
    for (Vec3& v : object.vertices) v = own ? v * scale + offset : v * scale;
  }
  for (std::size_t s = 1; s < out.environment.systems.size(); ++s) {
    move(out.environment.systems[s].placement.position);
    for (MotionKey& key : out.environment.systems[s].motion) move(key.placement.position);
  }
  for (GroundFace& face : out.environment.ground)
    for (Vec3& v : face.vertices) move(v);
  if (out.environment.view) move(out.environment.view->eye.position);
  move(out.centre);
  out.radius *= scale;
  return out;
}

SteppedWorld::SteppedWorld(const SearchWorld& world, SearchAxis axis, int step)
    : axis_(axis), step_(step) {
  double scale = 1;
  Vec3 offset;
  if (axis == SearchAxis::kSmall) scale = std::ldexp(1, -step);
  if (axis == SearchAxis::kLarge) scale = std::ldexp(1, step);
  // Few bits, so that worlds on a grid keep their shape.
  if (axis == SearchAxis::kOffset)
    offset = Vec3{1, -0.75, 0.25} * std::exp2(std::ceil(std::log2(world.radius)) + step);
  world_ = moved(world, scale, offset);
  database_ = prepare(world_.environment);
}

Raster SteppedWorld::raster() const {
  if (axis_ == SearchAxis::kRaster) return {1 << step_, 1 << step_};
  return axis_ == SearchAxis::kNear ? kCoarseRaster : kRaster;
}

std::optional<Viewpoint> SteppedWorld::viewpoint(Random& random) const {
  switch (axis_) {
    case SearchAxis::kClearance:
      return beside_a_plane(random);
    case SearchAxis::kNear:
      return before_a_face(random);
    case SearchAxis::kFar:
      return from_afar(random);
    case SearchAxis::kRaster:
    case SearchAxis::kSmall:
    case SearchAxis::kLarge:
    case SearchAxis::kOffset:
      break;
  }
  return clear_of_planes(random);
}

struct SteppedWorld::Sight {
  ActiveEnvironment active;
  FaceSet moving;
  PriorityList list;
  Measures measures;
};

SteppedWorld::Sight SteppedWorld::sight(const Viewpoint& viewpoint) const {
  Sight s;
  frame_calculator::Functional(database_).compute(viewpoint, kRaster, 0, s.active, s.moving);
  priority_processor::Functional<double> priority(PriorityMethod::kCounters);
  priority.compute(database_.systems[0].hierarchy, database_.systems[0].set, s.active,
                   database_.ground, s.list);
  s.measures = measures_of(database_, s.active, s.moving, s.list.items);
  return s;
}

Viewpoint SteppedWorld::plain(Random& random) const {
  const Vec3 eye =
      world_.centre + random_direction(random) * (world_.radius * random.between(0.8, 2.5));
  const Vec3 target =
      world_.centre + random_direction(random) * (world_.radius * random.between(0, 0.4));
  return looking(eye, target, kFov);
}

Viewpoint SteppedWorld::clear_of_planes(Random& random) const {
  Viewpoint best;
  double clearance = -1;
  for (int i = 0; i < kTries; ++i) {
    const Viewpoint candidate = plain(random);
    const Sight s = sight(candidate);
    if (s.list.items.empty() || !(s.measures.clearance > clearance)) continue;
    clearance = s.measures.clearance;
    best = candidate;
  }
  return clearance < 0 ? plain(random) : best;
}

// An eyepoint just above or below a separation plane, or a face, of what is in view.
std::optional<Viewpoint> SteppedWorld::beside_a_plane(Random& random) const {
  Viewpoint viewpoint = plain(random);
  const Sight s = sight(viewpoint);
  const PriorityHierarchy& hierarchy = database_.systems[0].hierarchy;
  const FaceSet& set = database_.systems[0].set;
  std::vector<const Plane*> separating, facing;
  for (const ActiveGroup& in_view : s.active.groups) {
    const Group& group = hierarchy.groups[in_view.group];
    for (std::uint32_t n = group.first_node; n < group.first_node + group.node_count; ++n) {
      const SeparationNode& node = hierarchy.nodes[n];
      if ((node.true_members & in_view.active) && (node.false_members & in_view.active))
        separating.push_back(&hierarchy.planes[node.plane]);
    }
  }
  for (const ItemRef& ref : s.list.items) {
    if (ref.set != SetId::kStatic) continue;
    const Item& item = set.items[ref.item];
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f)
      facing.push_back(&set.planes[set.faces[f].plane]);
  }
  const auto& planes = separating.empty() || random.below(2) == 0 ? facing : separating;
  if (planes.empty()) return std::nullopt;
  const Plane& plane = *planes[random.below(planes.size())];
  const Vec3 n = direction_of(plane.normal);
  Vec3& eye = viewpoint.eye.position;
  const double above = std::ldexp(s.measures.largest, -step_);
  eye = eye - n * dot(n, eye - plane.exact.p) + n * (random.below(2) == 0 ? above : -above);
  return viewpoint;
}

std::optional<Viewpoint> SteppedWorld::before_a_face(Random& random) const {
  const FaceSet& set = database_.systems[0].set;
  if (set.items.empty()) return std::nullopt;
  const Item& item = set.items[random.below(set.items.size())];
  const PreparedFace& face = set.faces[item.first_face + random.below(item.face_count)];
  Vec3 middle;
  const double share = 1.0 / face.corner_count;
  for (std::uint32_t c = 0; c < face.corner_count; ++c)
    middle = middle + set.vertices[item.first_vertex + set.corners[face.first_corner + c]] * share;
  const double height = std::ldexp(sight(plain(random)).measures.largest, -step_);
  const Vec3 n = direction_of(set.planes[face.plane].normal);
  const Vec3 beside = middle + direction_of(cross(n, random_direction(random))) * (1.5 * height);
  return looking(middle + n * height, beside, kWideFov);
}

// So far away that the world fills the raster through a narrow field of view.
Viewpoint SteppedWorld::from_afar(Random& random) const {
  const double distance = std::ldexp(1, step_);
  const Vec3 eye = world_.centre + random_direction(random) * (world_.radius * distance);
  const double half = std::atan(random.between(0.3, 1.2) / distance);
  return looking(eye, world_.centre, 2 * half * 180 / std::numbers::pi);
}

}  // namespace cigsim::stability
