// SPDX-License-Identifier: MIT
// What the separation program is given: a deck, or the objects of any other scene that stand still.
#pragma once

#include <filesystem>
#include <vector>

#include "models/environment/deck.hpp"

namespace cigsim {

/// Objects at most: dividing takes time with the cube of their number.
inline constexpr std::size_t kMostSeparated = 512;

struct SeparationInput {
  StumpDeck deck;
  Environment scene;  ///< the same objects, and what else the file holds
  std::vector<Notice> notices;
};

/// True when the file's name ends in .deck.
bool is_deck(const std::filesystem::path& file);

/// Throws InputError, and UsageError for a prepared database and for a scene with placed or moving
/// systems.
SeparationInput read_separation_input(const std::filesystem::path& file);

}  // namespace cigsim
