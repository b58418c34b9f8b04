// SPDX-License-Identifier: MIT
// A case for the priority resolver: what comes in, and when the links stall.
#pragma once

#include "models/machine/description.hpp"
#include "tests/support/random_lines.hpp"
#include "tests/support/stage_bench.hpp"

namespace cigsim::test {

/// Frames of lines, depths of links, and pauses.
struct ResolverCase {
  ResolverCase() = default;
  /// Random, with at most `most_faces` faces.
  explicit ResolverCase(unsigned seed, std::uint32_t most_faces = 300) : waits(seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    machine.raster.width = static_cast<int>(below(4) == 0 ? 1 + below(3) : 1 + below(70));
    machine.raster.height = static_cast<int>(1 + below(5));
    crossing_depth = 1 + below(below(2) ? 3 : 20);
    span_depth = 1 + below(below(2) ? 3 : 20);
    frames = 1 + below(3);
    const std::uint32_t faces = 1 + below(below(3) ? 12 : most_faces), most = below(2) ? 4 : 30;
    for (std::uint32_t l = 0; l < frames * static_cast<std::uint32_t>(machine.raster.height); ++l)
      lines.push_back(random_line(random, faces, most, width()));
    for (const auto& line : lines) words.insert(words.end(), line.begin(), line.end());
  }
  std::uint16_t width() const { return static_cast<std::uint16_t>(machine.raster.width); }

  MachineDescription machine;
  std::uint32_t crossing_depth = 16, span_depth = 16, frames = 1;
  std::vector<std::vector<CrossingWord>> lines;
  std::vector<CrossingWord> words;
  Waits waits = Waits::none();
};

}  // namespace cigsim::test
