// SPDX-License-Identifier: MIT
// Decks for the tests of Stump's program.
#pragma once

#include <string>

#include "models/environment/deck.hpp"
#include "models/environment/shapes.hpp"

namespace cigsim::test {

inline StumpDeck case_deck(int number) {
  return read_stump_deck(CIGSIM_SOURCE_DIR "/scenes/stump-case-" + std::to_string(number) +
                         ".deck");
}

/// Boxes between two corners each.
inline StumpDeck deck_of(const std::vector<std::pair<Vec3, Vec3>>& extents) {
  StumpDeck deck;
  for (const auto& [low, high] : extents) deck.objects.push_back(box(low, high));
  return deck;
}

/// Three bars along the axes, each over the next in a ring: a plane parts each two, but it cuts the
/// third.
inline StumpDeck ring_of_bars() {
  return deck_of({{{-5, 0, -1}, {5, 1, 0}}, {{-1, -5, 0}, {0, 5, 1}}, {{0, -1, -5}, {1, 0, 5}}});
}

/// Three wedges around the z axis that touch in it: the plane between two of them cuts the third,
/// and all three planes share the axis.
inline StumpDeck wedges() {
  const Vec3 corner[3] = {{2, 0, 0}, {-1, 2, 0}, {-1, -2, 0}};
  StumpDeck deck;
  for (int k = 0; k < 3; ++k) {
    const Vec3 up{0, 0, 1}, o{0, 0, 0}, a = corner[k], b = corner[(k + 1) % 3];
    Object wedge;
    wedge.vertices = {o, a, b, o + up, a + up, b + up};
    for (const auto& face : std::vector<std::vector<std::uint32_t>>{
             {0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}})
      wedge.faces.push_back({face, std::nullopt});
    deck.objects.push_back(wedge);
  }
  return deck;
}

}  // namespace cigsim::test
