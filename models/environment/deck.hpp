// SPDX-License-Identifier: MIT
// A card deck of Stump 1986 (app. A): objects, and the separation planes that an operator adds.
//
// Fixed columns. Columns 1-2 hold the type: "V " a vertex (5-7 number I3, 8-15, 16-23, 24-31
// coordinates F8.2), "F " a face (5-34 vertex numbers, ten of I3), "S " an operator's plane (5-76
// three points, nine of F8.2), "E " the end. Columns 73-80 of V and F cards are free for sequence
// numbers. FORTRAN rules: blanks within a field count for nothing, an empty field is 0, and F8.2
// without a decimal point has two decimals. A V card after F cards begins the next object.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "models/environment/environment.hpp"
#include "models/environment/read.hpp"

namespace cigsim {

struct StumpDeck {
  std::vector<Object> objects;              ///< faces anticlockwise (the cards list them clockwise)
  std::vector<std::array<Vec3, 3>> planes;  ///< three points of each operator's plane, card order
  std::vector<Notice> notices;
};

/// Throws InputError with the card's line; `name` stands for the file in messages. Published
/// limits (100 vertices, 200 face entries) do not apply.
StumpDeck parse_deck(std::string_view text, const std::string& name);

/// The deck of a file.
StumpDeck read_stump_deck(const std::filesystem::path& file);

}  // namespace cigsim
