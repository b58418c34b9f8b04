// SPDX-License-Identifier: MIT
// Files that a library carries inside it (cmake/embed.cmake).
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cigsim {

struct EmbeddedFile {
  std::string_view path;  ///< below the folder that the build names
  std::string_view text;
};

/// The text of the file `path`. Throws std::out_of_range when `files` has none.
inline std::string_view embedded_text(std::span<const EmbeddedFile> files, std::string_view path) {
  for (const EmbeddedFile& file : files)
    if (file.path == path) return file.text;
  throw std::out_of_range("no embedded file " + std::string(path));
}

}  // namespace cigsim
