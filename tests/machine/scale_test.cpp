// SPDX-License-Identifier: MIT
#include "models/machine/scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/environment/random.hpp"

namespace cigsim {
namespace {

Database with_vertex(double x) {
  Database database;
  database.systems.resize(1);
  database.systems[0].set.vertices = {{x, 0, 0}};
  return database;
}

TEST(Scale, IsTheLargestPowerThatKeepsToHalfTheWord) {
  const WordFormats formats;
  for (const double most : {1.0, 1.5, 1000.0, 0x1p20, 3e-9, 1e12}) {
    const int scale = coordinate_scale(with_vertex(-most), formats);
    EXPECT_LE(std::ldexp(most, scale), 0x1p29) << most;
    EXPECT_GT(std::ldexp(most, scale + 1), 0x1p29) << most;
  }
}

TEST(Scale, FollowsTheWidthOfTheWord) {
  WordFormats narrow;
  narrow.coordinate_bits = 20;
  EXPECT_EQ(coordinate_scale(with_vertex(100), WordFormats()) -
                coordinate_scale(with_vertex(100), narrow),
            11);
}

TEST(Scale, LeavesRoomForTheEye) {
  const WordFormats formats;
  for (const double reach : {10.0, 200.0, 201.0, 0x1p20, 1e9}) {
    const int scale = coordinate_scale(with_vertex(100), formats, reach);
    std::uint64_t overflows = 0;
    coordinate_word(reach, scale, formats, overflows);
    coordinate_word(-reach, scale, formats, overflows);
    EXPECT_EQ(overflows, 0u) << reach;
    const int without = coordinate_scale(with_vertex(100), formats);
    EXPECT_EQ(scale == without, reach <= 255) << reach;  // words are powers of two
  }
}

TEST(Scale, AnEmptyDatabaseHasOne) {
  Database database;
  database.systems.resize(1);
  EXPECT_EQ(coordinate_scale(database, {}), 0);
}

TEST(CoordinateWord, RoundsHalvesUpAndSaturates) {
  const WordFormats formats;
  std::uint64_t overflows = 0;
  EXPECT_EQ(coordinate_word(2.5, 0, formats, overflows), 3);
  EXPECT_EQ(coordinate_word(-2.5, 0, formats, overflows), -2);
  EXPECT_EQ(coordinate_word(-2.75, 1, formats, overflows), -5);
  EXPECT_EQ(overflows, 0u);
  EXPECT_EQ(coordinate_word(1e300, 0, formats, overflows), (1 << 30) - 1);
  EXPECT_EQ(coordinate_word(-1e300, 0, formats, overflows), -(1 << 30));
  EXPECT_EQ(coordinate_word(0x1p30, 0, formats, overflows), (1 << 30) - 1);
  EXPECT_EQ(overflows, 3u);
}

TEST(DirectionWord, OneIsExactAndNarrowWordsKeepTheirBits) {
  WordFormats formats;
  EXPECT_EQ(direction_word(1, formats), 1 << 30);
  EXPECT_EQ(direction_word(-1, formats), -(1 << 30));
  formats.direction_fraction = 12;
  const Word word = direction_word(std::sqrt(0.5), formats);
  EXPECT_EQ(word % (1 << 18), 0);
  EXPECT_NEAR(word / 0x1p30, std::sqrt(0.5), 0x1p-13);
}

// A point of the environment, through the words and through doubles: the same place on the raster.
TEST(ViewWords, ProjectAsTheViewTransformDoes) {
  const std::uint64_t seed = 20261122;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  const WordFormats formats;
  for (int i = 0; i < 1000; ++i) {
    ViewTransform view;
    view.eye = {random.between(-1000, 1000), random.between(-1000, 1000), 5};
    // Rows of any orthonormal system will do.
    const double heading = random.between(-4, 4), c = std::cos(heading), s = std::sin(heading);
    view.rotation.row[0] = {s, c, 0};
    view.rotation.row[1] = {c, -s, 0};
    view.rotation.row[2] = {0, 0, 1};
    view.raster = {64 + static_cast<int>(random.between(0, 2000)), 480};
    view.focal = random.between(20, 4000);
    const int scale = 18;
    std::uint64_t overflows = 0;
    const ViewWords words = view_words(view, scale, formats, overflows);
    EXPECT_EQ(overflows, 0u);
    const double ahead = random.between(10, 1000);
    const double right = random.between(-1, 1) * ahead * view.raster.width / 2 / view.focal;
    const Vec3 d = {ahead * s + right * c, ahead * c - right * s, 0};
    double uvw[3];
    for (int r = 0; r < 3; ++r)
      uvw[r] = (words.matrix[r][0] * d.x + words.matrix[r][1] * d.y + words.matrix[r][2] * d.z);
    const double column = view.raster.width / 2.0 * (1 + uvw[1] / uvw[0]);
    EXPECT_NEAR(column, view.raster.width / 2.0 + view.focal * right / ahead, 1e-3);
    for (const auto& row : words.matrix)
      for (const Word element : row) EXPECT_LE(std::abs(element), 1 << 30);
  }
}

}  // namespace
}  // namespace cigsim
