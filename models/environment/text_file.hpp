// SPDX-License-Identifier: MIT
// A whole input file in memory, with one clear error for each way that this can fail.
#pragma once

#include <filesystem>
#include <string>

namespace cigsim {

/// The bytes of `file`. Throws InputError when it is missing, a folder, empty or unreadable.
std::string read_whole_file(const std::filesystem::path& file);

/// The ending without its dot, in lower case: "obj" for "A.OBJ", "" for none.
std::string lower_ending(const std::filesystem::path& file);

}  // namespace cigsim
