// SPDX-License-Identifier: MIT
// An eyepoint's path: a table of viewpoints, one row a frame.
//
// Comma-separated text. The first line names the columns: x, y, z, heading, pitch, roll and, if
// wanted, fov; in any order, others are ignored. Empty lines and lines that begin with # do not
// count.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/environment/environment.hpp"

namespace cigsim {

struct PathRow {
  Placement eye;
  std::optional<double> fov;  ///< in every row or in none
};

/// At least one row. `name` stands for the file in messages. Throws InputError with the line.
std::vector<PathRow> parse_path(std::string_view text, const std::string& name);
std::vector<PathRow> read_path(const std::filesystem::path& file);

/// The viewpoint at `position`, in rows from 0; between rows linear, angles the short way round,
/// held beyond the ends. At a whole position the row itself, exactly.
PathRow at_position(const std::vector<PathRow>& rows, double position);

/// `count` positions spread evenly from the first row to the last.
std::vector<double> even_positions(std::size_t rows, std::size_t count);

}  // namespace cigsim
