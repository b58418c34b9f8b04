// SPDX-License-Identifier: MIT
#include "sim/point_groups.hpp"

#include "models/environment/input_error.hpp"
#include "models/environment/placement.hpp"
#include "models/environment/point_file.hpp"
#include "models/environment/read.hpp"

namespace cigsim {

std::vector<PointGroup> read_point_groups(const std::filesystem::path& file, bool per_object) {
  if (is_point_file(file)) return {{"points", read_points(file)}};
  const Environment environment = read_environment(file).environment;
  std::vector<PointGroup> groups;
  if (!per_object) groups.push_back({"points", {}});
  for (const Object& object : environment.objects) {
    if (object.vertices.empty()) continue;
    if (per_object) groups.push_back({object.name, {}});
    std::vector<Vec3>& points = groups.back().points;
    const std::vector<Vec3> here = placed(object.vertices, first_placement(environment, object));
    points.insert(points.end(), here.begin(), here.end());
  }
  if (groups.empty() || groups.front().points.empty())
    throw InputError(file.string(), 0, "has no vertices of objects; name a scene that has some");
  return groups;
}

void add_points_option(CLI::App& command, std::string& file) {
  command
      .add_option("FILE", file,
                  "A scene, whose objects' vertices are taken, or points, one a line: x y z (.xyz) "
                  "or x,y,z (.csv)")
      ->required()
      ->type_name("");
}

}  // namespace cigsim
