// SPDX-License-Identifier: MIT
// Small files of each format that Assimp reads, written here; real ones where they are installed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "models/environment/read.hpp"
#include "tests/support/scratch.hpp"

// Assimp leaks where it gives up on a damaged file; read by the leak sanitizer alone.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }

namespace cigsim {
namespace {

const std::string kOff =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

const std::string kAc3d =
    "AC3Db\nMATERIAL \"red\" rgb 1 0 0  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 0  trans 0\n"
    "MATERIAL \"blue\" rgb 0 0 1  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 0  trans 0\n"
    "OBJECT world\nkids 1\nOBJECT poly\nname \"tip\"\nloc 10 20 30\nnumvert 4\n0 0 0\n1 0 0\n0 2 "
    "0\n"
    "0 0 3\nnumsurf 2\nSURF 0x0\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nSURF 0x0\nmat 1\nrefs 3\n"
    "0 0 0\n1 0 0\n3 0 0\nkids 0\n";

const std::string kStl =
    "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid one\n";

/// A triangle (1, 2, 3) (4, 2, 3) (1, 5, 3) in a buffer inside the file, under a node moved by x.
std::string gltf(const std::string& buffer = "AACAPwAAAEAAAEBAAACAQAAAAEAAAEBAAACAPwAAoEAAAEBA") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"name": "moved", "mesh": 0, "translation": [100, 0, 0]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 4}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [1, 2, 3], "max": [4, 5, 3]}],
 "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)" +
         buffer + "\"}]}\n";
}

std::string little(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
  return text;
}
std::string chunk(std::uint32_t id, const std::string& contents) {
  return little(id, 2) + little(static_cast<std::uint32_t>(contents.size() + 6), 4) + contents;
}
std::string floats(std::initializer_list<float> values) {
  std::string bytes;
  for (const float v : values) {
    std::uint32_t bits;
    std::memcpy(&bits, &v, 4);
    bytes += little(bits, 4);
  }
  return bytes;
}

/// 3DS chunks: main 4D4D, editor 3D3D, object 4000, triangle mesh 4100, vertices 4110, faces 4120.
std::string three_ds() {
  const std::string vertices = little(3, 2) + floats({1, 2, 3, 4, 2, 3, 1, 5, 3});
  const std::string faces =
      little(1, 2) + little(0, 2) + little(1, 2) + little(2, 2) + little(7, 2);
  const std::string mesh = chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces));
  return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("part\0", 5) + mesh)));
}

std::string binary_stl() {
  std::string bytes(80, 'x');
  bytes += little(1, 4) + floats({0, 0, 1, 1, 2, 3, 4, 2, 3, 1, 5, 3}) + little(0, 2);
  return bytes;
}

class MeshReader : public testing::Test {
 protected:
  ReadResult read(const std::string& name, const std::string& bytes) {
    return read_environment(scratch_.write(name, bytes));
  }
  Object only(const std::string& name, const std::string& bytes) {
    const Environment e = read(name, bytes).environment;
    EXPECT_EQ(e.objects.size(), 1u) << name;
    return e.objects.empty() ? Object() : e.objects[0];
  }
  std::string error(const std::string& name, const std::string& bytes) {
    return test::message_of([&] { read(name, bytes); });
  }
  test::Scratch scratch_;
};

const std::vector<Vec3> kTriangle{{1, 2, 3}, {4, 2, 3}, {1, 5, 3}};

TEST_F(MeshReader, OffIsTakenAsItStands) {
  const Object o = only("a.off", kOff);
  EXPECT_EQ(o.vertices.size(), 4u);
  EXPECT_EQ(o.faces.size(), 4u);
  EXPECT_NE(std::find(o.vertices.begin(), o.vertices.end(), Vec3{0, 0, 1}), o.vertices.end());
}

TEST_F(MeshReader, Ac3dIsTurnedAndItsMaterialsStayOneObject) {
  const Object o = only("a.ac", kAc3d);
  EXPECT_EQ(o.name, "tip");
  ASSERT_EQ(o.faces.size(), 2u);
  EXPECT_EQ(o.faces[0].colour, (Colour{255, 0, 0}));
  EXPECT_EQ(o.faces[1].colour, (Colour{0, 0, 255}));
  // y up (x, y, z) is z up (x, -z, y); moved by (10, 20, 30).
  const std::vector<Vec3> expected{{10, -30, 20}, {11, -30, 20}, {10, -30, 22}, {10, -33, 20}};
  EXPECT_EQ(o.vertices, expected);
}

TEST_F(MeshReader, StlVerticesAreJoined) {
  const Object o = only("a.STL", kStl);
  EXPECT_EQ(o.vertices.size(), 4u);
  EXPECT_EQ(o.faces.size(), 2u);
  EXPECT_EQ(only("b.stl", binary_stl()).vertices, kTriangle);
}

TEST_F(MeshReader, GltfIsTurnedAndMovedByItsNode) {
  const Object o = only("a.gltf", gltf());
  EXPECT_EQ(o.name, "moved");
  EXPECT_EQ(o.vertices, (std::vector<Vec3>{{101, -3, 2}, {104, -3, 2}, {101, -3, 5}}));
}

TEST_F(MeshReader, ThreeDsKeepsItsOwnAxes) {
  const Object o = only("a.3ds", three_ds());
  EXPECT_EQ(o.vertices, kTriangle);
}

TEST_F(MeshReader, CoordinatesThatAreNotFiniteAreErrors) {
  // The first float is a quiet NaN (0000c07f).
  const std::string nan = "AADAfwAAAEAAAEBAAACAQAAAAEAAAEBAAACAPwAAoEAAAEBA";
  EXPECT_NE(error("a.gltf", gltf(nan)).find("is not finite; correct its coordinates"),
            std::string::npos);
}

TEST_F(MeshReader, EmptyAndUnreadableScenesAreErrorsOnOneLine) {
  EXPECT_NE(error("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "nothing");
  for (const char* name : {"a.ac", "a.gltf", "a.glb", "a.ply", "a.stl", "a.off", "a.3ds"}) {
    const std::string message = error(name, "this is no scene\n");
    EXPECT_EQ(message.find(scratch_.path(name).string() + ":"), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(MeshReader, TruncatedAndDamagedFilesNeverCrash) {
  const std::pair<const char*, std::string> files[] = {{"a.off", kOff},    {"a.ac", kAc3d},
                                                       {"a.stl", kStl},    {"b.stl", binary_stl()},
                                                       {"a.gltf", gltf()}, {"a.3ds", three_ds()}};
  for (const auto& [name, bytes] : files)
    for (std::size_t n = 1; n < bytes.size(); n += 3) {
      error(name, bytes.substr(0, n));
      std::string damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ 0x15);
      error(name, damaged);
    }
  for (std::size_t n = 1; n < binary_stl().size(); n += 3)
    EXPECT_NE(error("b.stl", binary_stl().substr(0, n)), "nothing") << n;
}

TEST_F(MeshReader, InstalledModelsAreRead) {
  const std::filesystem::path models = "/usr/share/assimp/models";
  if (!std::filesystem::exists(models))
    GTEST_SKIP() << "package assimp-testmodels is not installed";
  // The same spider and figure in several formats: counts known from the formats that keep them.
  for (const char* name : {"STL/Wuson.stl", "OFF/Wuson.off", "PLY/Wuson.ply", "AC/Wuson.ac"}) {
    if (!std::filesystem::exists(models / name)) continue;
    const Environment e = read_environment(models / name).environment;
    ASSERT_EQ(e.objects.size(), 1u) << name;
    EXPECT_EQ(e.objects[0].vertices.size(), 2117u) << name;
    EXPECT_EQ(e.objects[0].faces.size(), 3732u) << name;
  }
}

}  // namespace
}  // namespace cigsim
