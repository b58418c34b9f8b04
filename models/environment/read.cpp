// SPDX-License-Identifier: MIT
#include "models/environment/read.hpp"

#include <array>
#include <string_view>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

using Reader = ReadResult (*)(const std::filesystem::path&);

struct Format {
  std::string_view ending;
  Reader reader;
};

constexpr std::array<Format, 12> kFormats{{{"json", read_json},
                                           {"cbor", read_json},
                                           {"deck", read_deck},
                                           {"cards", read_cards},
                                           {"obj", read_obj},
                                           {"ac", read_mesh},
                                           {"gltf", read_mesh},
                                           {"glb", read_mesh},
                                           {"ply", read_ply},
                                           {"stl", read_mesh},
                                           {"off", read_mesh},
                                           {"3ds", read_mesh}}};

std::string all_endings() {
  std::string list;
  for (const Format& format : kFormats) {
    if (!list.empty()) list += &format == &kFormats.back() ? " or " : ", ";
    list += '.';
    list += format.ending;
  }
  return list;
}

}  // namespace

ReadResult read_environment(const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  for (const Format& format : kFormats)
    if (format.ending == ending) return format.reader(file);
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string(), 0, "is a folder; name a scene file inside it");
  if (!std::filesystem::exists(file, error))
    throw InputError(file.string(), 0, "no such file; check the name and the folder");
  std::string what = "has no ending";
  if (!ending.empty()) what.assign("has the unknown ending .").append(ending);
  throw InputError(file.string(), 0, what + "; give a scene whose name ends in " + all_endings());
}

}  // namespace cigsim
