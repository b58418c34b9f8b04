// SPDX-License-Identifier: MIT
#include "models/database/prepare.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <span>

#include "models/database/detail/detail_partition.hpp"
#include "models/database/face_set_builder.hpp"
#include "models/database/hierarchy.hpp"
#include "models/database/partition.hpp"
#include "models/database/separation_table.hpp"
#include "models/database/shade.hpp"
#include "models/database/surface_polygons.hpp"
#include "models/environment/detail.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/placement.hpp"

namespace cigsim {
namespace {

struct Preparation {
  const Environment& environment;
  bool sun;          // shade stated colours too
  Vec3 towards_sun;  // the scene's sun, or the one that shades invented colours
  double contact_tolerance;
  const std::string& file;
  Notices notices;
  PreparationReport report;
};

Colour face_colour(const Preparation& p, std::uint32_t object, const Face& face,
                   const Plane& plane) {
  const Colour colour = face.colour.value_or(palette_colour(object + 1));
  // Without a sun only invented colours are shaded, so that bodies can be made out.
  if (!p.sun && face.colour) return colour;
  return shaded(colour, plane.normal, p.towards_sun);
}

// Systems without motion belong to the environment's own once they are placed.
bool stands_still(const CoordinateSystem& system) { return system.motion.empty(); }

// Adds an object's faces to the working set: one item when it is convex, else an item a face.
void add_object(Preparation& p, WorkSet& set, std::uint32_t object, std::uint32_t& order) {
  const Object& source_object = p.environment.objects[object];
  const CoordinateSystem& system =
      p.environment.systems[p.environment.models[source_object.model].system];
  const Surface surface = make_surface(
      stands_still(system) ? placed(source_object, system.placement) : source_object, p.notices);
  if (!p.environment.separation.empty() && !surface.convex)
    throw InputError(p.file, 0,
                     "object " + std::to_string(object + 1) +
                         " is no convex body, as a separation table needs; split it or remove "
                         "\"separation\"");
  p.report.convex_objects += surface.convex;
  p.report.unclosed_objects += !surface.closed && !surface.faces.empty();
  add_faces(
      set, surface,
      [&](const SurfaceFace& face) -> FaceOrigin {
        const Face& source = source_object.faces[face.source];
        return {object + 1, order++, face_colour(p, object, source, face.plane), !surface.closed};
      },
      [&] {
        if (!surface.convex) set.add_item(1);
      });
  if (surface.convex) set.add_item(static_cast<std::uint32_t>(surface.faces.size()));
}

// Every item a leaf, without planes.
Partition whole_items(const WorkSet& work) {
  Partition out;
  for (std::uint32_t i = 0; i < work.items.size(); ++i) out.leaves.push_back({i});
  return out;
}

// The items of every object that belongs to a system.
std::vector<ItemRange> add_objects(Preparation& p, std::uint32_t system, WorkSet& work) {
  std::vector<ItemRange> ranges(p.environment.objects.size());
  std::uint32_t order = 0;
  for (std::uint32_t o = 0; o < ranges.size(); ++o) {
    const std::uint32_t of = p.environment.models[p.environment.objects[o].model].system;
    ranges[o].first = static_cast<std::uint32_t>(work.items.size());
    if (of == system || (system == 0 && stands_still(p.environment.systems[of])))
      add_object(p, work, o, order);
    ranges[o].end = static_cast<std::uint32_t>(work.items.size());
  }
  return ranges;
}

// An item a leaf, then the placeholders of descriptions that have nothing where a choice stands.
void build_set(Preparation& p, const DetailPartition& divided, FaceSet& out) {
  FaceSetBuilder builder(divided.work, out);
  const std::vector<std::uint32_t> items = items_of_leaves(divided.tree);
  for (std::size_t leaf = 0; leaf < items.size(); ++leaf) {
    if (items[leaf] == kNone) continue;
    p.report.pieces += divided.tree.leaves[leaf].size();
    builder.add(divided.tree.leaves[leaf]);
  }
  for (const ChoiceLeaf& choice : divided.tree.choices)
    for (const std::optional<std::int32_t>& root : choice.roots)
      if (!root) builder.add_placeholder();
}

void add_figures(Preparation& p, const PreparedSystem& system, const Partition& tree) {
  p.notices.add("overlap within the contact tolerance: not cut", tree.tolerated);
  p.report.cuts += tree.cuts;
  for (const Item& item : system.set.items) p.report.items += item.face_count > 0;
  p.report.faces += system.set.faces.size();
  p.report.vertices += system.set.vertices.size();
  p.report.planes += system.hierarchy.planes.size();
  p.report.groups += system.hierarchy.groups.size();
  p.report.depth = std::max(p.report.depth, depth(system.hierarchy));
  p.report.pairs += pair_count(system.hierarchy);
  p.report.choices += system.hierarchy.choices.size();
}

PreparedSystem prepare_system(Preparation& p, std::uint32_t system,
                              const std::function<void(double)>& progress) {
  const CoordinateSystem& source = p.environment.systems[system];
  PreparedSystem out;
  out.name = source.name;
  out.placement = source.placement;
  out.motion = source.motion;
  DetailPartition divided;
  WorkSet& work = divided.work;
  work.contact_tolerance = p.contact_tolerance;
  const std::vector<ItemRange> objects = add_objects(p, system, work);
  const auto show = [&](std::uint64_t done, std::uint64_t all) {
    if (progress && done % 256 == 0) progress(static_cast<double>(done) / static_cast<double>(all));
  };
  const bool by_hand = !p.environment.separation.empty();
  if (by_hand)
    divided.tree = whole_items(work);
  else if (p.environment.choices.empty())
    divided.tree = partition(work, show);
  else
    divided = partition_with_choices(p.environment, work, objects, show);
  build_set(p, divided, out.set);
  out.hierarchy = by_hand ? table_hierarchy(p.environment, work, out.set, p.file)
                          : build_hierarchy(divided.tree, out.set);
  take_choices(divided.choices, out.hierarchy);
  std::vector<Sphere> spheres;
  for (const Item& item : out.set.items)
    if (item.face_count > 0) spheres.push_back(item.sphere);
  if (!spheres.empty()) out.sphere = enclosing(spheres);
  add_figures(p, out, divided.tree);
  p.notices.add(
      "choice that cannot be parted from other objects: its most detailed description stands",
      divided.given_up);
  p.notices.add("choice left out: its most detailed description has no face",
                divided.without_detail);
  return out;
}

// Ground faces in one item, the last drawn first, as convex faces that are seen from both sides.
FaceSet prepare_ground(Preparation& p) {
  WorkSet work;
  std::vector<std::uint32_t> leaf;
  const auto& ground = p.environment.ground;
  for (std::size_t g = ground.size(); g-- > 0;) {
    Object object;
    object.vertices = ground[g].vertices;
    Face face;
    for (std::uint32_t v = 0; v < object.vertices.size(); ++v) face.vertices.push_back(v);
    object.faces.push_back(face);
    Notices unclosed;
    const Surface surface = make_surface(object, unclosed);
    for (const Notice& notice : unclosed.list())
      if (!notice.what.starts_with("object")) p.notices.add("ground: " + notice.what, notice.count);
    const auto number = static_cast<std::uint32_t>(p.environment.objects.size() + g + 1);
    add_faces(
        work, surface,
        [&](const SurfaceFace&) -> FaceOrigin {
          return {number, 0, ground[g].colour, true};
        },
        [&] { leaf.push_back(work.add_item(1)); });
  }
  FaceSet out;
  if (!leaf.empty()) FaceSetBuilder(work, out).add(leaf);
  return out;
}

// Every vertex that stands still; those of the ground when there is no other.
std::vector<std::span<const Vec3>> standing_vertices(const Database& database) {
  std::vector<std::span<const Vec3>> sets;
  for (const PreparedSystem& system : database.systems)
    if (!system.set.vertices.empty() && system.motion.empty()) sets.push_back(system.set.vertices);
  if (sets.empty() && !database.ground.vertices.empty()) sets.push_back(database.ground.vertices);
  return sets;
}

// From the south-east and 25 degrees above, the nearest eyepoint from which a square picture holds
// everything, with a margin.
DefaultView sensible_view(const Database& database) {
  static constexpr Vec3 kOrigin[] = {{0, 0, 0}};
  std::vector<std::span<const Vec3>> sets = standing_vertices(database);
  if (sets.empty()) sets.push_back(kOrigin);
  DefaultView view;
  view.fov = 50;
  view.eye.heading = 330;
  view.eye.pitch = -25;
  const Mat3 axes = body_axes(view.eye);
  const double tangent = sin_degrees(view.fov / 2) / cos_degrees(view.fov / 2) / 1.08;
  const Vec3 origin = sets[0][0];
  // How far points stand out of a pyramid through `origin` on its four sides, and behind it.
  constexpr double kLeast = -std::numeric_limits<double>::infinity();
  double right = kLeast, left = kLeast, up = kLeast, down = kLeast, near = kLeast;
  for (const std::span<const Vec3> set : sets)
    for (const Vec3& p : set) {
      const Vec3 d = axes * (p - origin);
      right = std::max(right, d.y - tangent * d.x);
      left = std::max(left, -d.y - tangent * d.x);
      up = std::max(up, d.z - tangent * d.x);
      down = std::max(down, -d.z - tangent * d.x);
      near = std::max(near, -d.x);
    }
  const double fit = std::max(right + left, up + down) / (2 * tangent);
  const double back = fit > near ? fit : near + 1;
  view.eye.position = origin + axes.row[1] * ((right - left) / 2) +
                      axes.row[2] * ((up - down) / 2) - axes.row[0] * back;
  return view;
}

}  // namespace

Database prepare(const Environment& environment, const PrepareOptions& options) {
  if (options.most_detailed && !environment.choices.empty()) {
    PrepareOptions plain = options;
    plain.most_detailed = false;
    return prepare(most_detailed(environment), plain);
  }
  check_choices(environment);
  const auto start = std::chrono::steady_clock::now();
  const std::optional<Sun> sun = options.sun ? options.sun : environment.sun;
  Preparation p{environment,
                sun.has_value(),
                towards(sun.value_or(Sun{})),
                options.contact_tolerance,
                options.file,
                {},
                {}};
  if (!environment.separation.empty()) check_table(environment, options.file);
  Database database;
  database.name = environment.name;
  database.background = environment.background;
  database.object_count = static_cast<std::uint32_t>(environment.objects.size());
  for (const Object& object : environment.objects) database.object_names.push_back(object.name);
  for (std::uint32_t s = 0; s < environment.systems.size(); ++s)
    if (s == 0 || !stands_still(environment.systems[s]))
      database.systems.push_back(prepare_system(p, s, options.progress));
  database.ground = prepare_ground(p);
  database.view = environment.view ? *environment.view : sensible_view(database);
  p.report.objects = environment.objects.size();
  p.report.notices = p.notices.list();
  p.report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  database.report = std::move(p.report);
  return database;
}

}  // namespace cigsim
