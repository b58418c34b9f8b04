// SPDX-License-Identifier: MIT
// The geometry processor's page lists what every path of its microprogram costs.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "models/geometry_processor/program.hpp"

namespace cigsim::geometry_processor {
namespace {

TEST(GeometryMicroprogram, CostsAreThoseOfThePage) {
  std::ifstream page(CIGSIM_SOURCE_DIR "/docs/machine/geometry_processor.md");
  std::map<std::string, Cycle, std::less<>> listed;
  std::string line;
  while (std::getline(page, line) && line.find("**GP20**") == std::string::npos) {
  }
  while (std::getline(page, line) && line.rfind("## ", 0) != 0) {
    std::istringstream words(line);
    std::string bar, path, cost;
    words >> bar >> path >> bar >> cost;
    if (path.size() > 2 && path.front() == '`')
      listed[path.substr(1, path.size() - 2)] = std::stoll(cost);
  }
  EXPECT_EQ(listed, program(WordFormats()).costs);
}

TEST(GeometryMicroprogram, WiderWordsTakeTheirStepsMore) {
  const firmware::Program usual = program(WordFormats());
  WordFormats formats;
  formats.quotient_fraction += 4;  // two clocks a quotient
  formats.raster_fraction -= 4;    // two clocks a slope less
  const firmware::Program other = program(formats);
  EXPECT_EQ(other.cost("vertex_in"), usual.cost("vertex_in") + 4);
  EXPECT_EQ(other.cost("project_corner"), usual.cost("project_corner") + 4);
  EXPECT_EQ(other.cost("leaving"), usual.cost("leaving") + 2);
  EXPECT_EQ(other.cost("short"), usual.cost("short") + 2);
  EXPECT_EQ(other.cost("long"), usual.cost("long") - 2);
  EXPECT_EQ(other.cost("back"), usual.cost("back"));
}

}  // namespace
}  // namespace cigsim::geometry_processor
