// SPDX-License-Identifier: MIT
// Errors of pictures against brute force.
#include "sim/measure/picture_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "models/environment/random.hpp"

namespace cigsim {
namespace {

// Blocks of few objects, so that there are edges and places far from them.
Picture random_picture(Random& random, int width, int height) {
  Picture picture;
  picture.fit({width, height});
  const std::uint32_t objects = 1 + random.below(4);
  const int block = 1 + static_cast<int>(random.below(9));
  const std::uint64_t salt = random.bits();
  for (int r = 0; r < height; ++r)
    for (int c = 0; c < width; ++c) {
      Random place(salt + static_cast<std::uint64_t>(r / block * 1000 + c / block));
      const auto i = static_cast<std::size_t>(r * width + c);
      picture.numbers[i] = static_cast<std::uint16_t>(place.below(objects));
      picture.colours[i] = 0xff000000u | (picture.numbers[i] * 0x203040u + place.below(2));
    }
  return picture;
}

bool beside_a_change(const Picture& p, int c, int r) {
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * p.width + x); };
  const int neighbours[4][2] = {{c - 1, r}, {c + 1, r}, {c, r - 1}, {c, r + 1}};
  for (const auto& [x, y] : neighbours) {
    if (x < 0 || y < 0 || x >= p.width || y >= p.height) continue;
    if (p.numbers[at(x, y)] != p.numbers[at(c, r)] || p.colours[at(x, y)] != p.colours[at(c, r)])
      return true;
  }
  return false;
}

double distance_from_an_edge(const Picture& p, int c, int r) {
  double least = std::hypot(p.width, p.height);
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      if (beside_a_change(p, x, y)) least = std::min(least, std::hypot(x - c, y - r));
  return least;
}

PictureError by_brute_force(const Picture& picture, const Picture& right) {
  PictureError e;
  e.pictures = 1;
  for (int r = 0; r < right.height; ++r)
    for (int c = 0; c < right.width; ++c) {
      // The place of the centre on the other raster.
      const auto x = static_cast<int>(std::floor((c + 0.5) / right.width * picture.width + 1e-9));
      const auto y = static_cast<int>(std::floor((r + 0.5) / right.height * picture.height + 1e-9));
      const auto a = static_cast<std::size_t>(y * picture.width + x),
                 b = static_cast<std::size_t>(r * right.width + c);
      ++e.elements;
      bool other_colour = false;
      for (const std::uint32_t unit : {1u, 256u, 65536u}) {
        const auto difference =
            static_cast<std::uint32_t>(std::abs(static_cast<int>(picture.colours[a] / unit % 256) -
                                                static_cast<int>(right.colours[b] / unit % 256)));
        e.colour_sum += difference;
        e.worst_colour = std::max(e.worst_colour, difference);
        other_colour |= difference > 0;
      }
      e.wrong_colours += other_colour;
      if (picture.numbers[a] == right.numbers[b]) continue;
      ++e.wrong;
      e.worst_distance = std::max(e.worst_distance, distance_from_an_edge(right, c, r));
    }
  e.worst_share = static_cast<double>(e.wrong) / static_cast<double>(e.elements);
  e.worst_mean_colour =
      static_cast<double>(e.colour_sum) / static_cast<double>(e.elements * 3 * 255);
  return e;
}

TEST(PictureError, IsThatOfBruteForceOnAnyRaster) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto side = [&] { return 1 + static_cast<int>(random.below(20)); };
    const Picture right = random_picture(random, side(), side());
    const Picture picture = random.below(2) == 0 ? random_picture(random, right.width, right.height)
                                                 : random_picture(random, side(), side());
    const PictureError found = picture_error(picture, reference_picture(right)),
                       expected = by_brute_force(picture, right);
    EXPECT_NEAR(found.worst_distance, expected.worst_distance, 1e-12);
    PictureError same = found;
    same.worst_distance = expected.worst_distance;
    EXPECT_EQ(same, expected);
  }
}

TEST(PictureError, OfEqualPicturesIsNothing) {
  Random random(1);
  const Picture picture = random_picture(random, 31, 17);
  const PictureError error = picture_error(picture, reference_picture(picture));
  EXPECT_EQ(error.wrong, 0u);
  EXPECT_EQ(error.worst_distance, 0);
  EXPECT_EQ(error.colour_sum, 0u);
  EXPECT_EQ(error.elements, 31u * 17u);
}

TEST(PictureError, TwiceTheRasterWithTheSameContentsIsRight) {
  Random random(2);
  const Picture small = random_picture(random, 9, 7);
  Picture large;
  large.fit({18, 14});
  for (std::size_t r = 0; r < 14; ++r)
    for (std::size_t c = 0; c < 18; ++c) {
      large.numbers[r * 18 + c] = small.numbers[r / 2 * 9 + c / 2];
      large.colours[r * 18 + c] = small.colours[r / 2 * 9 + c / 2];
    }
  EXPECT_EQ(picture_error(large, reference_picture(small)).wrong, 0u);
  EXPECT_EQ(picture_error(small, reference_picture(large)).wrong, 0u);
}

// A wrong element within a surface is told from one beside an edge.
TEST(PictureError, TellsHowFarAWrongElementIsFromAnEdge) {
  Picture right;
  right.fit({20, 5});
  for (std::size_t i = 0; i < right.numbers.size(); ++i) right.numbers[i] = i % 20 >= 10;
  Picture wrong = right;
  wrong.numbers[2 * 20 + 9] = 1;
  EXPECT_EQ(picture_error(wrong, reference_picture(right)).worst_distance, 0);
  wrong.numbers[2 * 20 + 3] = 1;
  EXPECT_EQ(picture_error(wrong, reference_picture(right)).worst_distance, 6);
}

TEST(PictureError, WithoutAnEdgeTheDistanceIsTheDiagonal) {
  Picture right;
  right.fit({4, 3});
  Picture wrong = right;
  wrong.numbers[5] = 1;
  EXPECT_EQ(picture_error(wrong, reference_picture(right)).worst_distance, 5);
}

TEST(PictureError, AddsUp) {
  Picture right;
  right.fit({2, 2});
  Picture wrong = right;
  wrong.numbers[0] = 1;
  wrong.colours[0] = 0x0000ff;
  PictureError total = picture_error(right, reference_picture(right));
  total += picture_error(wrong, reference_picture(right));
  EXPECT_EQ(total.pictures, 2u);
  EXPECT_EQ(total.share(), 1.0 / 8);
  EXPECT_EQ(total.worst_share, 1.0 / 4);
  EXPECT_EQ(total.mean_colour(), 1.0 / 24);
  EXPECT_EQ(total.worst_mean_colour, 1.0 / 12);
  EXPECT_EQ(total.worst_colour, 255u);
}

}  // namespace
}  // namespace cigsim
