// SPDX-License-Identifier: MIT
// Random crossings of raster lines, as the edge orderer gives them.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "models/boundary/words.hpp"

namespace cigsim::test {

/// The crossings of one line and its end word. Each of up to `most` faces below `faces` has a left
/// and a right edge; among them are faces of no width, and faces whose right edge comes first, at
/// most an element earlier or anywhere. About one line in four is cut.
inline std::vector<CrossingWord> random_line(std::mt19937& random, std::uint32_t faces,
                                             std::uint32_t most, std::uint16_t width) {
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  std::vector<std::uint32_t> chosen(faces);
  for (std::uint32_t f = 0; f < faces; ++f) chosen[f] = f;
  std::shuffle(chosen.begin(), chosen.end(), random);
  chosen.resize(std::min(faces, below(most + 1)));
  std::vector<CrossingWord> line;
  for (const std::uint32_t face : chosen) {
    std::uint32_t a = below(width + 1u), b = below(width + 1u);
    const std::uint32_t kind = below(10);
    if (kind == 0) b = a;
    if (kind == 1) b = a == 0 ? 0 : a - 1;
    if (kind > 2 && b < a) std::swap(a, b);
    line.push_back({face, static_cast<std::uint16_t>(a), true});
    line.push_back({face, static_cast<std::uint16_t>(b), false});
  }
  std::sort(line.begin(), line.end(), [](const CrossingWord& x, const CrossingWord& y) {
    if (x.element != y.element) return x.element < y.element;
    if (x.left != y.left) return y.left;
    return x.face < y.face;
  });
  CrossingWord end;
  end.end = true;
  if (!line.empty() && below(4) == 0) {
    const std::size_t kept = below(static_cast<std::uint32_t>(line.size()));
    end.cut = true;
    end.element = line[kept].element;
    line.resize(kept);
  }
  line.push_back(end);
  return line;
}

}  // namespace cigsim::test
