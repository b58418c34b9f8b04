// SPDX-License-Identifier: MIT
#include "sim/rtl/sources.hpp"

#include <fmt/format.h>

#include "models/environment/write.hpp"

namespace cigsim {

void write_rtl_sources(const std::filesystem::path& folder) {
  for (const EmbeddedFile& file : embedded_rtl()) {
    const std::filesystem::path path = folder / file.path;
    std::filesystem::create_directories(path.parent_path());
    write_file(path, file.text);
  }
}

// FNV-1a, 64 bits (Fowler, Noll, Vo).
std::string rtl_hash(std::string_view stage) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](std::string_view text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  };
  const std::string own = fmt::format("rtl/{}/", stage);
  for (const EmbeddedFile& file : embedded_rtl())
    if (file.path.starts_with(own) || file.path.starts_with("rtl/common/")) {
      add(file.path);
      add(file.text);
    }
  return fmt::format("{:016x}", hash);
}

}  // namespace cigsim
