// SPDX-License-Identifier: MIT
// Writing scene files: whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

#include "models/environment/environment.hpp"

namespace cigsim {

/// Writes beside `file`, then renames. Throws InputError (naming the file and the system's reason:
/// no space, no folder, no permission) and leaves neither the file nor the temporary behind.
void write_file(const std::filesystem::path& file,
                const std::function<void(std::ostream&)>& write_contents);
void write_file(const std::filesystem::path& file, std::string_view contents);

/// JSON (.json), CBOR (.cbor) or OBJ (.obj, one `o` line an object) by the ending; reading the file
/// back gives an equal environment (for OBJ: its objects, in the environment's axes).
void write_environment(const Environment& environment, const std::filesystem::path& file);

}  // namespace cigsim
