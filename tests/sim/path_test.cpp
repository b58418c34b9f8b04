// SPDX-License-Identifier: MIT
#include "sim/path.hpp"

#include <gtest/gtest.h>

#include "models/environment/input_error.hpp"
#include "sim/embedded.hpp"

namespace cigsim {
namespace {

constexpr const char* kHeader = "x,y,z,heading,pitch,roll\n";

std::string fault_of(const std::string& text) {
  try {
    parse_path(text, "p.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(Path, ColumnsMayStandInAnyOrderAmongOthers) {
  const auto rows = parse_path(
      "\xEF\xBB\xBF# a comment\r\nframe, Roll,pitch,heading,z,y,x,fov\r\n\r\n"
      "one, 6, 5,4,3,2,+1,45\r\n# between\n two,0,0,0,0,0,-1e2,50",
      "p.csv");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].eye, (Placement{{1, 2, 3}, 4, 5, 6}));
  EXPECT_EQ(rows[0].fov, 45);
  EXPECT_EQ(rows[1].eye.position.x, -100);
  EXPECT_FALSE(parse_path(std::string(kHeader) + "1,2,3,4,5,6\n", "p.csv")[0].fov);
}

TEST(Path, FaultsNameFileAndLine) {
  const std::string header = kHeader;
  EXPECT_EQ(fault_of(header + "1,2,3,4,5,six\n"), "p.csv:2: roll: 'six' is not a finite number");
  EXPECT_EQ(fault_of(header + "1,2,3,4,5,6\n\n1,2,3,4,5\n"),
            "p.csv:4: has 5 fields, but 6 columns are named");
  EXPECT_EQ(fault_of("x,y,z,heading,pitch\n1,2,3,4,5\n"),
            "p.csv:1: there is no column 'roll'; name the columns x,y,z,heading,pitch,roll");
  for (const char* row : {"nan,2,3,4,5,6", "1,inf,3,4,5,6", "1,2,3,4,5,1e999", "1,2,3,4,5,",
                          "1,2,3,4,5,6,7", "1 2,3,4,5,6", "1,2,3,4,5,0x10"})
    EXPECT_EQ(fault_of(header + row).substr(0, 8), "p.csv:2:") << row;
  EXPECT_NE(fault_of("x,y,z,x,heading,pitch,roll\n").find("'x' is named twice"), std::string::npos);
}

TEST(Path, NoRowsIsAFault) {
  EXPECT_NE(fault_of("").find("is empty"), std::string::npos);
  EXPECT_NE(fault_of("# only a comment\n").find("is empty"), std::string::npos);
  EXPECT_NE(fault_of(kHeader).find("has no rows"), std::string::npos);
}

TEST(Path, FieldOfViewMustLieBetween0And180) {
  for (const char* fov : {"0", "180", "-5", "nan", "1e6"})
    EXPECT_EQ(
        fault_of(std::string("x,y,z,heading,pitch,roll,fov\n1,2,3,4,5,6,") + fov).substr(0, 12),
        "p.csv:2: fov")
        << fov;
}

TEST(Path, BetweenRowsPositionsAreLinearAndAnglesGoTheShortWay) {
  const std::vector<PathRow> rows{{{{0, 10, -4}, 350, -10, 170}, 40},
                                  {{{1, 20, -8}, 10, 10, -170}, 60},
                                  {{{5, 0, 0}, 100, 0, 0}, 20}};
  EXPECT_EQ(at_position(rows, 0.5).eye, (Placement{{0.5, 15, -6}, 360, 0, 180}));
  EXPECT_EQ(at_position(rows, 0.5).fov, 50);
  EXPECT_EQ(at_position(rows, 1).eye, rows[1].eye);
  EXPECT_EQ(at_position(rows, -3).eye, rows[0].eye);
  EXPECT_EQ(at_position(rows, 9).eye, rows[2].eye);
}

TEST(Path, FramesAreSpreadEvenlyFromTheFirstRowToTheLast) {
  EXPECT_EQ(even_positions(3, 5), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_EQ(even_positions(7, 1), std::vector<double>{0});
  EXPECT_EQ(even_positions(1, 3), (std::vector<double>{0, 0, 0}));
  const std::vector<double> rows = even_positions(300, 300);
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i], static_cast<double>(i));
}

TEST(Path, BuiltInApproachCanBeFlown) {
  const std::string_view approach = embedded_text(embedded_scenes(), "airfield-approach.csv");
  EXPECT_GT(parse_path(approach, "built-in").size(), 100u);
}

}  // namespace
}  // namespace cigsim
