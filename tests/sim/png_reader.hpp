// SPDX-License-Identifier: MIT
// Reading a PNG back, by another part of libpng than the one that the program writes with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cigsim {

struct RgbPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;  ///< R, G, B an element
};

/// Throws std::runtime_error unless the file is a whole PNG.
RgbPicture read_png(const std::filesystem::path& file);

}  // namespace cigsim
