// SPDX-License-Identifier: MIT
// The folder rtl/, which the program carries to build sizes of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "common/embedded_file.hpp"

namespace cigsim {

/// All files, with paths that begin with "rtl/".
std::span<const EmbeddedFile> embedded_rtl();

/// Writes them below `folder`.
void write_rtl_sources(const std::filesystem::path& folder);

/// 16 hex digits that change with the sources of a stage: its folder and rtl/common.
std::string rtl_hash(std::string_view stage);

}  // namespace cigsim
