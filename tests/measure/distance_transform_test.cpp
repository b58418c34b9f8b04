// SPDX-License-Identifier: MIT
// Distances against brute force over all marks.
#include "sim/measure/distance_transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/environment/random.hpp"

namespace cigsim {
namespace {

std::vector<std::uint32_t> by_brute_force(const std::vector<std::uint8_t>& marked, int width,
                                          int height) {
  std::vector<std::uint32_t> result;
  for (int r = 0; r < height; ++r)
    for (int c = 0; c < width; ++c) {
      std::uint32_t least = kNoDistance;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          if (marked[static_cast<std::size_t>(y * width + x)])
            least =
                std::min(least, static_cast<std::uint32_t>((x - c) * (x - c) + (y - r) * (y - r)));
      result.push_back(least);
    }
  return result;
}

TEST(DistanceTransform, IsThatOfBruteForce) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int width = 1 + static_cast<int>(random.below(24)),
              height = 1 + static_cast<int>(random.below(24));
    // From hardly any marks to nearly all.
    const double density = random.unit() * random.unit();
    std::vector<std::uint8_t> marked(static_cast<std::size_t>(width * height));
    for (std::uint8_t& mark : marked) mark = random.unit() < density;
    ASSERT_EQ(squared_distances(marked, width, height), by_brute_force(marked, width, height));
  }
}

TEST(DistanceTransform, OneMarkOfALongLine) {
  std::vector<std::uint8_t> marked(16384);
  marked.back() = 1;
  EXPECT_EQ(squared_distances(marked, 16384, 1).front(), 16383u * 16383u);
  EXPECT_EQ(squared_distances(marked, 1, 16384).front(), 16383u * 16383u);
}

TEST(DistanceTransform, WithoutAMarkThereIsNoDistance) {
  EXPECT_EQ(squared_distances(std::vector<std::uint8_t>(6), 3, 2),
            std::vector<std::uint32_t>(6, kNoDistance));
}

}  // namespace
}  // namespace cigsim
