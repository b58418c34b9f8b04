// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "models/environment/read.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

class ObjReader : public testing::Test {
 protected:
  ReadResult read(const std::string& text) {
    return read_environment(scratch_.write("a.obj", text));
  }
  std::vector<Object> objects(const std::string& text) { return read(text).environment.objects; }
  std::string error(const std::string& text) {
    std::string message = test::message_of([&] { read(text); });
    const std::string file = scratch_.path("a.obj").string();
    return message.find(file) == 0 ? message.substr(file.size()) : message;
  }
  std::uint64_t noticed(const std::string& text, const std::string& what) {
    for (const Notice& notice : read(text).notices)
      if (notice.what.find(what) != std::string::npos) return notice.count;
    return 0;
  }

  test::Scratch scratch_;
};

const std::string kFour = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST_F(ObjReader, EveryOLineIsOneObjectWithItsOwnVertices) {
  const auto o = objects(kFour + "o one\nf 1 2 3\no two\nv 5 5 5\nf 4 3 5\nf -1 2 4\no none\n");
  ASSERT_EQ(o.size(), 3u);
  EXPECT_EQ(o[0].name, "one");
  EXPECT_EQ(o[0].vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(o[0].faces, (std::vector<Face>{{{0, 1, 2}, {}}}));
  EXPECT_EQ(o[1].vertices, (std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}}));
  EXPECT_EQ(o[1].faces, (std::vector<Face>{{{2, 1, 3}, {}}, {{3, 0, 2}, {}}}));
  EXPECT_EQ(o[2].name, "none");
  EXPECT_TRUE(o[2].faces.empty());
  EXPECT_EQ(noticed(kFour + "o a\nf 1 2 3\no b\n", "objects without faces"), 1u);
}

TEST_F(ObjReader, FacesBeforeTheFirstOMakeAnObject) {
  const auto o = objects(kFour + "f 1 2 3\no late\nf 1 2 4\n");
  ASSERT_EQ(o.size(), 2u);
  EXPECT_EQ(o[0].name, "");
  EXPECT_EQ(o[1].name, "late");
}

TEST_F(ObjReader, GroupsMakeObjectsOnlyWithoutO) {
  const auto o = objects(kFour + "g a\nf 1 2 3\ng b\nf 1 2 4\ng a\nf 2 3 4\ng empty\n");
  ASSERT_EQ(o.size(), 2u);
  EXPECT_EQ(o[0].name, "a");
  EXPECT_EQ(o[0].faces.size(), 2u);
  EXPECT_EQ(objects(kFour + "o x\ng a\nf 1 2 3\ng b\nf 1 2 4\n").size(), 1u);
}

TEST_F(ObjReader, ReadsEveryFormOfACornerAndContinuedLines) {
  const auto o =
      objects("vt 0 0\nvn 0 0 1\n" + kFour +
              "f 1/1 2/1 3/1\nf 1//1 2//1 4//1\nf 1/1/1 \\\n 3/1/1 \\\r\n 4/1/1 # end\r\n");
  ASSERT_EQ(o.size(), 1u);
  EXPECT_EQ(o[0].faces, (std::vector<Face>{{{0, 1, 2}, {}}, {{0, 1, 3}, {}}, {{0, 2, 3}, {}}}));
}

TEST_F(ObjReader, CoordinatesAreDoublesReadExactly) {
  const auto o =
      objects("v 0.1 -1.5e-3 +16777217.0625\nv 1 0 0 1 0.5 0.5 0.5\nv 0 1e-400 0\nf 1 2 3\n");
  EXPECT_EQ(o[0].vertices[0], (Vec3{0.1, -0.0015, 16777217.0625}));
  EXPECT_EQ(o[0].vertices[2], (Vec3{0, 0, 0}));
}

TEST_F(ObjReader, VerticesMayFollowTheirFaces) {
  EXPECT_EQ(objects("f 1 2 3\n" + kFour)[0].vertices.size(), 3u);
}

TEST_F(ObjReader, MaterialsGiveColoursAndMissingOnesAreNoticed) {
  scratch_.write("two words.mtl", "newmtl red one\nKd 1 0.5 0\n\nnewmtl dull\nKa 1 1 1\n");
  const std::string text =
      "mtllib two words.mtl\n" + kFour +
      "usemtl red one\nf 1 2 3\nusemtl dull\nf 1 2 4\nusemtl rgb_0a0bff\nf 2 3 4\n";
  const auto o = objects(text);
  EXPECT_EQ(o[0].faces[0].colour, (Colour{255, 128, 0}));
  EXPECT_EQ(o[0].faces[1].colour, std::nullopt);
  EXPECT_EQ(o[0].faces[2].colour, (Colour{10, 11, 255}));
  EXPECT_EQ(noticed(text, "material without a colour"), 1u);
  EXPECT_EQ(noticed("mtllib no.mtl\n" + kFour + "f 1 2 3\n", "libraries not found"), 1u);
}

TEST_F(ObjReader, WhatIsDroppedIsCounted) {
  const std::string text = kFour + "v 9 9 9\np 1\nl 1 2\nl 2 3\nf 1 1 2\nf 1 2 3\n";
  EXPECT_EQ(noticed(text, "points, lines"), 3u);
  EXPECT_EQ(noticed(text, "fewer than three different"), 1u);
  EXPECT_EQ(noticed(text, "vertices that no face uses"), 2u);
  EXPECT_EQ(objects(text)[0].vertices.size(), 3u);
}

TEST_F(ObjReader, EveryFaultIsNamedWithItsLine) {
  EXPECT_EQ(error("v 0 0 0\nv 1 0\n"), ":2: v needs three coordinates; complete the line");
  EXPECT_EQ(error("v 0 0 x1\n"), ":1: \"x1\" is no coordinate; write a decimal number");
  EXPECT_EQ(error("\n\nv 0 nan 0\n"), ":3: \"nan\" is not finite; write a finite coordinate");
  EXPECT_EQ(error("v 0 -inf 0\n"), ":1: \"-inf\" is not finite; write a finite coordinate");
  EXPECT_EQ(error("v 1e999 0 0\n"), ":1: \"1e999\" is not finite; write a finite coordinate");
  EXPECT_EQ(error(kFour + "f 1 2\n"),
            ":5: a face needs at least 3 vertices, not 2; complete or remove the line");
  EXPECT_EQ(error(kFour + "f 1 2 0\n"), ":5: vertex number 0 in a face; vertices count from 1");
  EXPECT_EQ(error(kFour + "\nf 1 2 5\n"), ":6: vertex 5 is out of range; the file has 4 vertices");
  EXPECT_EQ(error(kFour + "f 1 2 -5\n"),
            ":5: vertex -5 is out of range; 4 vertices stand before this line");
  EXPECT_EQ(error(kFour + "f 1 2 99999999999\n").substr(0, 36),
            ":5: vertex 99999999999 is out of ran");
  EXPECT_EQ(error(kFour + "f 1 2 \\\n b\n"),
            ":6: \"b\" is no vertex of a face; write vertex numbers from 1");
  EXPECT_EQ(error(kFour), ": holds no object with faces; add f lines");
  EXPECT_EQ(error(kFour + "o a\no b\n"), ": holds no object with faces; add f lines");
}

}  // namespace
}  // namespace cigsim
