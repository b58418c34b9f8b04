// SPDX-License-Identifier: MIT
// Edges stepped over a whole raster, against rational arithmetic.
#include "sim/stability/accumulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "sim/stability/envelope.hpp"

namespace cigsim::stability {
namespace {

Format words(int quotient, int raster) {
  Format format{"words", Arithmetic::kMachine, machine_preset("unlimited")};
  format.machine.formats.quotient_fraction = quotient;
  format.machine.formats.raster_fraction = raster;
  return format;
}

Accumulation measured(const Format& format, int lines, int trials = 20) {
  AccumulationOptions options;
  options.trials = trials;
  options.lines = lines;
  options.formats = {format};
  return measure_accumulation(options).at(0);
}

AccumulationPoint after(const Accumulation& a, int lines) {
  const auto found = std::find_if(a.points.begin(), a.points.end(),
                                  [&](const AccumulationPoint& p) { return p.lines == lines; });
  if (found == a.points.end()) throw std::logic_error("no such number of lines");
  return *found;
}

TEST(Accumulation, BoundsHoldInEveryFormat) {
  for (const Format& format : searched_formats())
    for (const int lines : {64, 4096, 8190})
      for (const AccumulationPoint& point : measured(format, lines).points)
        EXPECT_TRUE(point.held) << format.name << ", " << point.lines << " of " << lines
                                << " lines: " << point.worst << " of " << point.bound;
}

TEST(Accumulation, WhatTheDescriptionsSayOfTheirSlopesHolds) {
  const auto preset = [](const char* name) {
    return Format{name, Arithmetic::kMachine, machine_preset(name)};
  };
  EXPECT_LT(after(measured(preset("asupt1975"), 4096), 1024).worst, 1.0 / 256);
  EXPECT_LT(after(measured(preset("nasa1968"), 4096), 480).worst, 1.0 / 16);
}

TEST(Accumulation, ErrorsGrowWithTheLinesOnWordsAndNotInFloat) {
  const Accumulation narrow = measured(words(24, 12), 4096);
  EXPECT_GT(after(narrow, 4096).worst, 50 * after(narrow, 64).worst);
  const Accumulation floats = measured({"float", Arithmetic::kFloat, {}}, 4096);
  EXPECT_GT(after(floats, 4096).worst, 0);
  EXPECT_LT(after(floats, 4096).worst, 4 * after(floats, 16).worst);
}

TEST(Accumulation, FourFractionBitsGoAstrayByElements) {
  const Accumulation narrow = measured(words(24, 4), 4096);
  const AccumulationPoint last = after(narrow, 4096);
  EXPECT_GT(last.worst, 20);
  EXPECT_LE(last.worst, 4096.0 / 32 + 1);  // half a unit of 1/16 a line
  EXPECT_GT(last.wrong, last.crossings / 2);
  EXPECT_TRUE(last.held);
}

TEST(Accumulation, DoublesAreRightOnEveryLine) {
  const Accumulation doubles = measured({"double", Arithmetic::kDouble, {}}, 8190);
  const AccumulationPoint last = after(doubles, 8190);
  EXPECT_EQ(last.worst, 0);  // to 2^-16 element
  EXPECT_EQ(last.wrong, 0u);
  EXPECT_GE(last.crossings, 20u * 8189);
}

TEST(Accumulation, ARasterThatWordsDoNotHoldIsRefused) {
  EXPECT_THROW(measured(words(24, 18), 8192), std::invalid_argument);
  EXPECT_THROW(measured(words(24, 18), 33), std::invalid_argument);
  EXPECT_THROW(measured(words(24, 18), 0), std::invalid_argument);
}

}  // namespace
}  // namespace cigsim::stability
