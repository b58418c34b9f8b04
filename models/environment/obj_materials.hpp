// SPDX-License-Identifier: MIT
// The colours of Wavefront materials.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "models/environment/environment.hpp"

namespace cigsim {

/// Material names with their diffuse colours (Kd, 0 to 1 scaled to 0 to 255).
using ObjMaterials = std::map<std::string, Colour, std::less<>>;

/// Adds the materials of one library. False when the file is not there.
bool read_obj_materials(const std::filesystem::path& file, ObjMaterials& materials);

/// The colour that a name `rgb_RRGGBB` says by itself (hexadecimal; the project's own writer uses
/// such names so that an OBJ file needs no library).
std::optional<Colour> colour_of_name(std::string_view material);

}  // namespace cigsim
