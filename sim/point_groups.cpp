// SPDX-License-Identifier: MIT
#include "sim/point_groups.hpp"

#include "models/environment/input_error.hpp"
#include "models/environment/placement.hpp"
#include "models/environment/point_file.hpp"
#include "models/environment/read.hpp"

namespace cigsim {
namespace {

std::vector<Vec3> placed_vertices(const Environment& environment, const Object& object) {
  const CoordinateSystem& system =
      environment.systems.at(environment.models.at(object.model).system);
  const Placement placement =
      system.motion.empty() ? system.placement : system.motion.front().placement;
  if (placement == Placement{}) return object.vertices;
  const Placing place(placement);
  std::vector<Vec3> out;
  out.reserve(object.vertices.size());
  for (const Vec3& v : object.vertices) out.push_back(place(v));
  return out;
}

}  // namespace

std::vector<PointGroup> read_point_groups(const std::filesystem::path& file, bool per_object) {
  if (is_point_file(file)) return {{"points", read_points(file)}};
  const Environment environment = read_environment(file).environment;
  std::vector<PointGroup> groups;
  if (!per_object) groups.push_back({"points", {}});
  for (const Object& object : environment.objects) {
    if (object.vertices.empty()) continue;
    if (per_object) groups.push_back({object.name, {}});
    std::vector<Vec3>& points = groups.back().points;
    const std::vector<Vec3> placed = placed_vertices(environment, object);
    points.insert(points.end(), placed.begin(), placed.end());
  }
  if (groups.empty() || groups.front().points.empty())
    throw InputError(file.string(), 0, "has no vertices of objects; name a scene that has some");
  return groups;
}

}  // namespace cigsim
