// SPDX-License-Identifier: MIT
// Reading scene files of every format, chosen by the file's ending.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "models/environment/environment.hpp"

namespace cigsim {

/// One kind of thing that a reader or the preparation dropped or repaired, and how often.
struct Notice {
  std::string what;
  std::uint64_t count = 0;
  friend bool operator==(const Notice&, const Notice&) = default;
};

struct ReadResult {
  Environment environment;
  std::vector<Notice> notices;
};

/// Reads .json and .cbor (the project's own, docs/scene-format.md), .deck (Stump 1986, app. A),
/// .cards (Pfister, cards.hpp), .obj, .ply, and through Assimp .ac, .gltf, .glb, .stl, .off, .3ds.
/// Throws InputError on anything unusable.
ReadResult read_environment(const std::filesystem::path& file);

ReadResult read_json(const std::filesystem::path& file);
ReadResult read_deck(const std::filesystem::path& file);
ReadResult read_cards(const std::filesystem::path& file);
ReadResult read_obj(const std::filesystem::path& file);
ReadResult read_ply(const std::filesystem::path& file);
ReadResult read_mesh(const std::filesystem::path& file);

/// Reads the project's JSON from memory; `name` stands for the file in messages.
ReadResult parse_json(std::string_view text, const std::string& name);

}  // namespace cigsim
