// SPDX-License-Identifier: MIT
// Pictures as files: PNG for the eye, PGM for object numbers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "models/boundary/transactions.hpp"

namespace cigsim {

/// The bytes of a PNG: RGB, 8 bits a channel.
std::string png_bytes(const Picture& picture);

/// The same as a file. Throws InputError when it cannot be written, and leaves nothing then.
void write_png(const Picture& picture, const std::filesystem::path& file);

/// The colours of a PNG as write_png() makes it, whose size must be width x height. Throws
/// InputError with `name` when it is another file.
std::vector<std::uint32_t> png_colours(std::string_view bytes, int width, int height,
                                       const std::string& name);

/// Object numbers: P5, maxval 65535, two bytes an element, the high one first.
void write_pgm(const Picture& picture, const std::filesystem::path& file);

}  // namespace cigsim
