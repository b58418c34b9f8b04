// SPDX-License-Identifier: MIT
// Facts about the picture of a small wave: where its lines and texts are.
#include "sim/wave/wave_picture.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace cigsim {
namespace {

using Kind = ViewRow::Kind;

// Ten cycles of 125 ns, in units of 1 ns.
Wave small_wave() {
  Wave wave;
  wave.first = 0;
  wave.last = 1250;
  wave.traces = {{{"top.valid", "", 1, false}, {{0, "0"}, {250, "1"}, {500, "0"}}},
                 {{"top.element", "[9:0]", 10, false},
                  {{0, "xxxxxxxxxx"}, {250, "0000000101"}, {1000, "0001100100"}}},
                 {{"top.a<b", "", 1, false}, {{0, "z"}}}};
  return wave;
}

const std::vector<WavePictureRow> kRows{{Kind::kHeading, "In & out", Radix::kHexadecimal, 0},
                                        {Kind::kSignal, "valid", Radix::kBinary, 0},
                                        {Kind::kSignal, "element", Radix::kDecimal, 1},
                                        {Kind::kBlank, "", Radix::kHexadecimal, 0},
                                        {Kind::kSignal, "a<b", Radix::kBinary, 2}};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

// Of the text `text`.
double x_of(const std::string& svg, const std::string& text) {
  std::smatch match;
  const bool found =
      std::regex_search(svg, match, std::regex("x=\"([0-9.]+)\" y=\"[0-9.]+\">" + text + "<"));
  EXPECT_TRUE(found) << text;
  return found ? std::stod(match[1]) : 0;
}

TEST(WavePicture, ValuesAreShownByTheirNames) {
  std::vector<WavePictureRow> rows = kRows;
  rows[2].names = std::make_shared<ValueNames>(ValueNames::parse("5 go <\n", "names"));
  const std::string svg = wave_picture(small_wave(), rows, {});
  EXPECT_EQ(count(svg, ">go &lt;<"), 1u);
  EXPECT_EQ(count(svg, ">100<"), 1u);
  EXPECT_EQ(count(svg, ">5<") + 1, count(wave_picture(small_wave(), kRows, {}), ">5<"));
}

TEST(WavePicture, ValuesNamesAndHeadingsAreThereAsText) {
  const std::string svg = wave_picture(small_wave(), kRows, {});
  for (const char* text : {">In &amp; out<", ">valid<", ">element<", ">a&lt;b<", ">5<", ">100<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(count(svg, "class=\"x\""), 1u) << "the element is unknown at first";
  EXPECT_EQ(count(svg, "class=\"z\""), 1u);
  EXPECT_EQ(count(svg, "class=\"f\""), 1u) << "one time high";
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("http://"), svg.find("http://www.w3.org/2000/svg")) << "nothing is fetched";
}

TEST(WavePicture, TimeRunsEvenlyFromLeftToRight) {
  const std::string svg = wave_picture(small_wave(), kRows, {});
  const double tenth = (x_of(svg, "1000") - x_of(svg, "500")) / 4;  // a cycle
  EXPECT_NEAR(x_of(svg, "500") - x_of(svg, "0"), 4 * tenth, 0.2);
  EXPECT_NEAR(x_of(svg, "100"), x_of(svg, "1000") + tenth, 0.2) << "in the middle of its box";
  EXPECT_NEAR(x_of(svg, "5"), x_of(svg, "500") + tenth, 6) << "between cycles 2 and 8";
}

TEST(WavePicture, CyclesAreCountedInTheLengthGiven) {
  const std::string svg = wave_picture(small_wave(), kRows, {.cycle_ns = 250, .width = 1200});
  EXPECT_EQ(x_of(svg, "4"), x_of(svg, "1000"));
  EXPECT_NE(svg.find("width=\"1200\""), std::string::npos);
}

TEST(WavePicture, WhatIsTooCloseIsABar) {
  Wave wave = small_wave();
  wave.last = 1'000'000;
  for (WaveTime t = 500'000; t < 600'000; t += 100)
    wave.traces[1].changes.push_back({t, t % 200 == 0 ? "0000000001" : "0000000010"});
  const std::string svg = wave_picture(wave, kRows, {});
  EXPECT_EQ(count(svg, "class=\"e\""), 2u) << "the first microsecond, and the busy time";
  EXPECT_LT(svg.size(), 8000u);
}

TEST(WavePicture, AWindowNeedsALength) {
  Wave wave = small_wave();
  wave.last = wave.first;
  EXPECT_THROW(wave_picture(wave, kRows, {}), std::invalid_argument);
}

TEST(WavePicture, NamesLoseTheScopesThatAllShare) {
  EXPECT_EQ(short_names({"a.b.c", "a.b.d.e"}), (std::vector<std::string>{"c", "d.e"}));
  EXPECT_EQ(short_names({"a.bc", "a.bd"}), (std::vector<std::string>{"bc", "bd"}));
  EXPECT_EQ(short_names({"top.clock", "top.a.x", "top.a.y.z"}),
            (std::vector<std::string>{"clock", "x", "y.z"}));
  EXPECT_EQ(short_names({"top.x", "top.a.x", "top.a.y"}),
            (std::vector<std::string>{"top.x", "top.a.x", "top.a.y"}));
  EXPECT_EQ(short_names({"x.y"}), (std::vector<std::string>{"x.y"}));
  EXPECT_EQ(short_names({"a.b", "c.b"}), (std::vector<std::string>{"a.b", "c.b"}));
}

}  // namespace
}  // namespace cigsim
