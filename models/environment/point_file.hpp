// SPDX-License-Identifier: MIT
// Plain lists of points: .xyz (three numbers a line, blanks between) and .csv (commas between).
#pragma once

#include <filesystem>
#include <vector>

#include "models/numeric/vec3.hpp"

namespace cigsim {

/// True when the file's ending is .xyz or .csv.
bool is_point_file(const std::filesystem::path& file);

/// One point a line, x y z in any unit. Empty lines and what follows # are skipped; the first line
/// of a .csv may name the columns, x,y,z. Throws InputError, with the line, for anything else, for
/// numbers that are not finite, and for a file without points.
std::vector<Vec3> read_points(const std::filesystem::path& file);

}  // namespace cigsim
