// SPDX-License-Identifier: MIT
#include "sim/wave/radix.hpp"

#include <gtest/gtest.h>

#include <bitset>
#include <random>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

TEST(Radix, ValuesAreWrittenAsInBooks) {
  EXPECT_EQ(value_text("101101", Radix::kBinary), "101101");
  EXPECT_EQ(value_text("1011010", Radix::kOctal), "132");
  EXPECT_EQ(value_text("1011010", Radix::kHexadecimal), "5a");
  EXPECT_EQ(value_text("0001011010", Radix::kDecimal), "90");
  EXPECT_EQ(value_text("1111", Radix::kSigned), "-1");
  EXPECT_EQ(value_text("1000", Radix::kSigned), "-8");
  EXPECT_EQ(value_text("0111", Radix::kSigned), "7");
  EXPECT_EQ(value_text("0000", Radix::kDecimal), "0");
  EXPECT_EQ(value_text("0100100001101001", Radix::kText), "Hi");
}

TEST(Radix, UnknownBitsSpoilTheirDigitOnly) {
  EXPECT_EQ(value_text("x0010001", Radix::kHexadecimal), "x1");
  EXPECT_EQ(value_text("zzzz0001", Radix::kHexadecimal), "z1");
  EXPECT_EQ(value_text("zz0z", Radix::kHexadecimal), "x");
  EXPECT_EQ(value_text("0x01", Radix::kDecimal), "x");
  EXPECT_EQ(value_text("zzzz", Radix::kSigned), "z");
}

// 2^100 - 1 and -2^99, worked out by bc.
TEST(Radix, NoWidthIsTooLarge) {
  EXPECT_EQ(value_text(std::string(100, '1'), Radix::kDecimal), "1267650600228229401496703205375");
  EXPECT_EQ(value_text("1" + std::string(99, '0'), Radix::kSigned),
            "-633825300114114700748351602688");
}

TEST(Radix, RandomWordsAgreeWithTheLibrary) {
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 1000; ++i) {
    const auto word = static_cast<std::uint32_t>(random());
    const std::string digits = std::bitset<32>(word).to_string();
    EXPECT_EQ(value_text(digits, Radix::kDecimal), std::to_string(word));
    EXPECT_EQ(value_text(digits, Radix::kSigned), std::to_string(static_cast<std::int32_t>(word)));
    char hex[9];
    std::snprintf(hex, sizeof hex, "%08x", word);
    EXPECT_EQ(value_text(digits, Radix::kHexadecimal), hex);
  }
}

TEST(Radix, NamesAreChecked) {
  EXPECT_EQ(parse_radix("--signal", "signed"), Radix::kSigned);
  EXPECT_THROW(parse_radix("--signal", "roman"), UsageError);
}

}  // namespace
}  // namespace cigsim
