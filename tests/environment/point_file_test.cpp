// SPDX-License-Identifier: MIT
// Lists of points: what is read, and one clear line for each thing that cannot be.
#include "models/environment/point_file.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "models/environment/input_error.hpp"
#include "models/environment/off_writer.hpp"
#include "models/environment/write.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

class PointFile : public testing::Test {
 protected:
  std::vector<Vec3> read(const std::string& name, const std::string& text) {
    write_file(scratch_.folder() / name, text);
    return read_points(scratch_.folder() / name);
  }
  std::string error(const std::string& name, const std::string& text) {
    try {
      read(name, text);
    } catch (const InputError& e) {
      const std::string what = e.what();
      return what.substr(what.find(name) + name.size());
    }
    return "none";
  }
  const test::Scratch scratch_;
};

TEST_F(PointFile, ReadsBlanksOrCommas) {
  const std::vector<Vec3> expected{{1, 2.5, -3}, {0, 1e-320, 1e300}};
  EXPECT_EQ(read("a.xyz", "1 2.5 -3\n\n# remark\n 0\t1e-320  +1e300  # more\r\n"), expected);
  EXPECT_EQ(read("a.csv", "\xEF\xBB\xBFX, y, Z\r\n1,2.5,-3\r\n0 , 1e-320,1e300"), expected);
  EXPECT_EQ(read("b.CSV", "1,2.5,-3\n0,1e-320,1e300\n"), expected);
  EXPECT_TRUE(is_point_file("A.XYZ"));
  EXPECT_FALSE(is_point_file("a.obj"));
}

TEST_F(PointFile, NamesTheLineOfWhatItCannotRead) {
  EXPECT_EQ(error("a.xyz", "1 2 3\n4 5\n"), ":2: has 2 numbers; write one point a line, as x y z");
  EXPECT_EQ(error("a.xyz", "1 2 3 4\n"), ":1: has 4 numbers; write one point a line, as x y z");
  EXPECT_EQ(error("a.csv", "\n1,2,3,\n"), ":2: has 4 numbers; write one point a line, as x,y,z");
  EXPECT_EQ(error("a.csv", "1;2;3\n"), ":1: has 1 number; write one point a line, as x,y,z");
  EXPECT_EQ(error("a.csv", "1,2,3\nx,y,z\n"),
            ":2: 'x' is no finite decimal number; write a point as x,y,z");
  for (const char* bad : {"nan", "inf", "1.5.2", "0x10", "--1", "+-1", "1e", "\"1\""})
    EXPECT_EQ(error("a.xyz", std::string("1 2 ") + bad),
              std::string(":1: '") + bad + "' is no finite decimal number; write a point as x y z");
  EXPECT_EQ(error("a.xyz", "1 2 1e999"),
            ":1: '1e999' is beyond the range of doubles; scale the points");
  EXPECT_EQ(error("a.xyz", "# nothing\n\n"), ": has no points; write one a line, as x y z");
  EXPECT_EQ(error("a.csv", "x,y,z\n"), ": has no points; write one a line, as x,y,z");
  EXPECT_EQ(error("a.csv", ",,\n"), ":1: '' is no finite decimal number; write a point as x,y,z");
}

TEST_F(PointFile, EmptyAndMissingFilesAreTold) {
  EXPECT_EQ(error("a.xyz", ""), ": is empty; write the scene again or name another file");
  EXPECT_THROW(read_points(scratch_.folder() / "none.xyz"), InputError);
  EXPECT_THROW(read_points(scratch_.folder()), InputError);
}

TEST(OffWriter, WritesAllObjectsAsOneMesh) {
  Environment environment;
  environment.models.push_back({"m", 0});
  const Object triangle{"a", 0, {{0, 0, 0}, {0.1, 0, 0}, {0, 1e300, 0}}, {{{0, 1, 2}, {}}}};
  const Object square{"b", 0, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{{0, 1, 2, 3}, {}}}};
  environment.objects = {triangle, square};
  std::ostringstream out;
  write_off(environment, out);
  EXPECT_EQ(out.str(),
            "OFF\n7 2 0\n0 0 0\n0.1 0 0\n0 1e+300 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
            "3 0 1 2\n4 3 4 5 6\n");
}

}  // namespace
}  // namespace cigsim
