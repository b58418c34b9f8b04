// SPDX-License-Identifier: MIT
#include "sim/arguments.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

TEST(Arguments, NumbersAreWholeWordsAndFinite) {
  EXPECT_EQ(parse_number("n", "-1.5e3"), -1500);
  EXPECT_EQ(parse_number("n", "+2"), 2);
  EXPECT_EQ(parse_number("n", ".5"), 0.5);
  for (const char* bad : {"", " 1", "1 ", "1x", "0x10", "nan", "inf", "-infinity", "1e999", "1,5",
                          "+-1", "--1", "1e"})
    EXPECT_THROW(parse_number("n", bad), UsageError) << bad;
}

TEST(Arguments, WholeNumbersStayInRange) {
  EXPECT_EQ(parse_whole("n", "18446744073709551615", 0, ~0ull), ~0ull);
  for (const char* bad : {"", "-1", "+1", "0", "11", "1.0", "18446744073709551616", "ten"})
    EXPECT_THROW(parse_whole("n", bad, 1, 10), UsageError) << bad;
}

TEST(Arguments, VectorsHaveThreeNumbers) {
  EXPECT_EQ(parse_vector("--eye", "-5,0,3.25"), (Vec3{-5, 0, 3.25}));
  for (const char* bad :
       {"", "1,2", "1,2,3,4", "1,2,", ",1,2", "1, 2,3", "1;2;3", "a,b,c", "1,2,nan"})
    EXPECT_THROW(parse_vector("--eye", bad), UsageError) << bad;
}

TEST(Arguments, RastersReachFromOneElementTo16384) {
  const Raster smallest = parse_raster("--raster", "1x1");
  EXPECT_EQ(smallest.width, 1);
  const Raster raster = parse_raster("--raster", "640x16384");
  EXPECT_EQ(raster.width, 640);
  EXPECT_EQ(raster.height, 16384);
  for (const char* bad :
       {"", "640", "0x0", "0x5", "5x0", "16385x1", "-1x1", "1x1x1", "x", "1 x 1", "640X480"})
    EXPECT_THROW(parse_raster("--raster", bad), UsageError) << bad;
}

TEST(Arguments, FieldOfViewLiesBetween0And180) {
  EXPECT_EQ(parse_fov("--fov", "179.9"), 179.9);
  for (const char* bad : {"0", "-1", "180", "nan"})
    EXPECT_THROW(parse_fov("--fov", bad), UsageError) << bad;
}

TEST(Arguments, SunStandsBetweenNadirAndZenith) {
  EXPECT_EQ(parse_sun("--sun", "-30,90").elevation, 90);
  EXPECT_THROW(parse_sun("--sun", "0,91"), UsageError);
  EXPECT_THROW(parse_sun("--sun", "0"), UsageError);
}

TEST(Arguments, MessagesNameTheArgumentAndTheChoices) {
  try {
    parse_choice<int>("--number", "half", {{"float", 1}, {"double", 2}});
    FAIL() << "an unknown word was taken";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "--number: 'half' is not known; choose from float, double");
  }
  EXPECT_EQ(parse_choice<int>("--number", "double", {{"float", 1}, {"double", 2}}), 2);
}

TEST(Arguments, EndingsDoNotMindCapitals) {
  EXPECT_NO_THROW(check_ending("-o", "a.b/SCENE.JSON", {"json", "cbor"}));
  for (const char* bad : {"scene", "scene.txt", "json", ".json", ""})
    EXPECT_THROW(check_ending("-o", bad, {"json", "cbor"}), UsageError) << bad;
}

}  // namespace
}  // namespace cigsim
