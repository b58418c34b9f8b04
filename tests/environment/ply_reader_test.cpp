// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "models/environment/read.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

const std::string kText =
    "ply\nformat ascii 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty double x\n"
    "property double y\nproperty float z\nproperty uchar quality\nelement face 2\n"
    "property list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nend_header\n"
    "0.1 0 0 7\n1 0 0 7\n0 1 0 7\n0 0 1 7\n3 0 1 2 255 0 9\n4 0 1 2 3 1 2 3\n";

class PlyReader : public testing::Test {
 protected:
  Environment read(const std::string& bytes) {
    return read_environment(scratch_.write("a.ply", bytes)).environment;
  }
  std::string error(const std::string& bytes) {
    const std::string message = test::message_of([&] { read(bytes); });
    const std::string file = scratch_.path("a.ply").string();
    return message.find(file) == 0 ? message.substr(file.size()) : message;
  }
  static std::string with(const std::string& from, const std::string& to) {
    std::string text = kText;
    return text.replace(text.find(from), from.size(), to);
  }
  test::Scratch scratch_;
};

TEST_F(PlyReader, TextIsReadInDoublePrecision) {
  const Environment e = read(kText);
  ASSERT_EQ(e.objects.size(), 1u);
  EXPECT_EQ(e.objects[0].vertices,
            (std::vector<Vec3>{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(e.objects[0].faces[0], (Face{{0, 1, 2}, Colour{255, 0, 9}}));
  EXPECT_EQ(e.objects[0].faces[1], (Face{{0, 1, 2, 3}, Colour{1, 2, 3}}));
}

TEST_F(PlyReader, BothByteOrdersAreRead) {
  const std::string rest =
      "element vertex 3\nproperty float x\nproperty short y\nproperty double z\nelement face 1\n"
      "property list uchar ushort vertex_index\nend_header\n";
  // 1.0f is 3f800000, -2 is fffe, 0.5 is 3fe0000000000000.
  const std::string zero(14, '\0');
  const std::string big = std::string("\x3f\x80\0\0\xff\xfe\x3f\xe0\0\0\0\0\0\0", 14) + zero +
                          std::string("\0\0\0\0\0\1\0\0\0\0\0\0\0\0", 14) +
                          std::string("\3\0\0\0\1\0\2", 7);
  const std::string little = std::string("\0\0\x80\x3f\xfe\xff\0\0\0\0\0\0\xe0\x3f", 14) + zero +
                             std::string("\0\0\0\0\1\0\0\0\0\0\0\0\0\0", 14) +
                             std::string("\3\0\0\1\0\2\0", 7);
  const std::vector<Vec3> expected{{1, -2, 0.5}, {0, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(read("ply\nformat binary_big_endian 1.0\n" + rest + big).objects[0].vertices, expected);
  const std::string whole = "ply\nformat binary_little_endian 1.0\n" + rest + little;
  EXPECT_EQ(read(whole).objects[0].vertices, expected);
  for (std::size_t n = 1; n < whole.size(); ++n)
    ASSERT_NE(error(whole.substr(0, n)), "nothing") << n;
}

TEST_F(PlyReader, EveryTruncationOfTextIsAnError) {
  for (std::size_t n = 1; n + 2 < kText.size(); ++n)
    ASSERT_NE(error(kText.substr(0, n)), "nothing") << n;
}

TEST_F(PlyReader, EveryFaultIsNamedWithItsLine) {
  EXPECT_EQ(error("plx\n"), ":1: is no PLY file; its first line must be \"ply\"");
  EXPECT_EQ(error(with("double y", "real y")).substr(0, 24), ":6: unknown type \"real\" ");
  EXPECT_EQ(error(with("vertex 4", "vertex four")).substr(0, 14), ":4: an element");
  EXPECT_EQ(error(with("ascii", "utf8")).substr(0, 26), ":14: unknown format \"utf8\"");
  EXPECT_EQ(error(with("\n1 0 0 7", "\n1 nan 0 7")),
            ":16: vertex 1 is not finite; correct its coordinates");
  EXPECT_EQ(error(with("0 1 0 7", "0 one 0 7")),
            ":17: \"one\" is no number; write a decimal number");
  EXPECT_EQ(error(with("3 0 1 2 255", "3 0 1 -2 255")).substr(0, 12), ":19: face 0 ");
  EXPECT_EQ(error(with("3 0 1 2 255", "3 0 1 9 255")),
            ": a face names vertex 9 of 4, counted from 0; correct the face");
  EXPECT_EQ(error(with("face 2", "face 9")),
            ":20: ends at face 2 of 9; the file is cut off, copy or export it again");
}

}  // namespace
}  // namespace cigsim
