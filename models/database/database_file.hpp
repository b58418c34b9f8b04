// SPDX-License-Identifier: MIT
// The prepared database as a file: JSON or CBOR by the ending (docs/scene-format.md).
#pragma once

#include <filesystem>

#include "models/database/database.hpp"

namespace cigsim {

/// True when the file is a prepared database rather than a scene.
bool is_database(const std::filesystem::path& file);

/// Throws InputError when the file is not a whole and consistent database of this version.
Database read_database(const std::filesystem::path& file);

void write_database(const Database& database, const std::filesystem::path& file);

}  // namespace cigsim
