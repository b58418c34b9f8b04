// SPDX-License-Identifier: MIT
// The points that a command works on: of a scene, or of a plain list.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "models/numeric/vec3.hpp"

namespace cigsim {

struct PointGroup {
  std::string name;  ///< of the object; "points" for all together
  std::vector<Vec3> points;
};

/// The vertices of all objects of a scene as one group, or one group an object, in the
/// environment's axes (a moving system stands where its first key says); or the points of a .xyz or
/// .csv file, always one group. Ground faces do not take part. Throws InputError, for a scene
/// without vertices too.
std::vector<PointGroup> read_point_groups(const std::filesystem::path& file, bool per_object);

/// Adds the positional option FILE for such points, which must be given.
void add_points_option(CLI::App& command, std::string& file);

}  // namespace cigsim
