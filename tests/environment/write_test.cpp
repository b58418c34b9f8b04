// SPDX-License-Identifier: MIT
#include "models/environment/write.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <limits>

#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

/// A scene that uses every field, with doubles that short decimals would lose.
Environment rich(bool in_order) {
  const double awkward = std::nextafter(0.1, 1);
  Environment e;
  e.name = "rich \"quoted\" \xc3\xa9\n";
  e.background = {1, 2, 255};
  e.view = DefaultView{{{awkward, -1e-300, 1e22}, 1.0 / 3, -2.0 / 3, 5e-324}, awkward};
  e.sun = Sun{awkward, -12.5};
  e.systems.push_back({"fixed", {{1, 2, awkward}, 10, 20, 30}, {}});
  e.systems.push_back({"moving", {}, {{0, {{1, 1, 1}, 0, 0, 0}}, {2.5, {{2, 2, 2}, 350, 0, -1}}}});
  e.models = {{"a", 0}, {"empty", 0}, {"b", 1}, {"c", 2}};
  const std::vector<Vec3> corners{
      {0, 0, 0}, {awkward, 0, 0}, {0, 1e300, 0}, {0, 0, 9007199254740993.0}};
  const Face plain{{0, 1, 2}, {}}, red{{0, 1, 3}, Colour{255, 0, 0}};
  e.objects = {{"plain", 0, corners, {plain, plain}},
               {"mixed", 0, corners, {plain, red}},
               {"red", 2, corners, {red, red}},
               {"faceless", 3, {}, {}}};
  if (!in_order) std::swap(e.objects[0], e.objects[2]);
  e.ground = {{{{-1, -1, 0}, {1, -1, 0}, {0, awkward, 0}}, {3, 4, 5}}};
  e.separation = {{{awkward, 0, -1}, -awkward, {{1, 2}}}, {{0, 1, 0}, 0, {{4, 1}, {3, 2}}}};
  return e;
}

TEST(WriteEnvironment, JsonAndCborReadBackEqual) {
  const test::Scratch scratch;
  for (const char* name : {"a.json", "a.cbor"})
    for (const bool in_order : {true, false}) {
      const Environment e = rich(in_order);
      write_environment(e, scratch.path(name));
      EXPECT_EQ(read_environment(scratch.path(name)).environment, e) << name << in_order;
    }
  EXPECT_LT(std::filesystem::file_size(scratch.path("a.cbor")),
            std::filesystem::file_size(scratch.path("a.json")));
}

TEST(WriteEnvironment, TheSignOfZeroSurvives) {
  const test::Scratch scratch;
  Environment e = rich(true);
  e.sun->azimuth = -0.0;
  for (const char* name : {"a.json", "a.cbor"}) {
    write_environment(e, scratch.path(name));
    EXPECT_TRUE(std::signbit(read_environment(scratch.path(name)).environment.sun->azimuth));
  }
}

TEST(WriteEnvironment, RandomDoublesReadBackToTheBit) {
  const test::Scratch scratch;
  Environment e = rich(true);
  std::vector<Vec3>& vertices = e.objects[0].vertices;
  std::uint64_t state = 1;
  while (vertices.size() < 5000) {
    const auto next = [&] {
      state = state * 6364136223846793005u + 1442695040888963407u;
      return std::bit_cast<double>(state ^ state >> 29);
    };
    const Vec3 v{next(), next(), next()};
    if (std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) vertices.push_back(v);
  }
  for (const char* name : {"a.json", "a.cbor"}) {
    write_environment(e, scratch.path(name));
    EXPECT_EQ(read_environment(scratch.path(name)).environment.objects[0].vertices, vertices);
  }
}

TEST(WriteEnvironment, JsonHasOneFaceALine) {
  const test::Scratch scratch;
  write_environment(generate_environment("cubes", {4, 1}), scratch.path("a.json"));
  const std::string text = test::bytes_of(scratch.path("a.json"));
  std::size_t faces = 0;
  for (std::size_t at = 0; (at = text.find("\n      [", at)) != std::string::npos; ++at) ++faces;
  EXPECT_EQ(faces, 4u * (8 + 6));
}

TEST(WriteEnvironment, ObjReadsBackTheObjects) {
  const test::Scratch scratch;
  for (const char* kind : {"city", "random", "brushes", "soup"}) {
    Environment e = generate_environment(kind, {50, 3});
    e.objects[3].faces[0].colour = Colour{1, 20, 255};
    e.objects[5].faces.back().colour = Colour{0, 0, 0};
    write_environment(e, scratch.path("a.obj"));
    EXPECT_EQ(read_environment(scratch.path("a.obj")).environment.objects, e.objects) << kind;
  }
}

TEST(WriteEnvironment, ObjStandsInTheEnvironmentsAxes) {
  const test::Scratch scratch;
  Environment e;
  e.systems.push_back({"turned", {{100, 200, 300}, 90, 0, 0}, {}});
  e.models = {{"m", 1}};
  e.objects = {{"o", 0, {{0, 0, 0}, {0, 1, 0}, {1, 0, 5}}, {{{0, 1, 2}, {}}}}};
  write_environment(e, scratch.path("a.obj"));
  // Heading 90 turns ahead (y) to the east and right (x) to the south.
  const auto v = read_environment(scratch.path("a.obj")).environment.objects[0].vertices;
  EXPECT_EQ(v, (std::vector<Vec3>{{100, 200, 300}, {101, 200, 300}, {100, 199, 305}}));
}

TEST(WriteEnvironment, OtherEndingsAndReferencesToNothingAreErrors) {
  const test::Scratch scratch;
  EXPECT_NE(test::message_of([&] {
              write_environment({}, scratch.path("a.stl"));
            }).find("written as .json, .cbor or .obj; choose"),
            std::string::npos);
  Environment e;
  e.objects.push_back({});
  EXPECT_THROW(write_environment(e, scratch.path("a.json")), std::invalid_argument);
  EXPECT_EQ(scratch.files(), 0u);
}

TEST(WriteFile, ReplacesTheWholeFileOrNothing) {
  const test::Scratch scratch;
  write_file(scratch.path("a"), "first");
  write_file(scratch.path("a"), "second");
  EXPECT_EQ(test::bytes_of(scratch.path("a")), "second");
  EXPECT_THROW(write_file(scratch.path("a"),
                          [](std::ostream& out) {
                            out << "half";
                            throw std::runtime_error("stop");
                          }),
               std::runtime_error);
  EXPECT_EQ(test::bytes_of(scratch.path("a")), "second");
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(WriteFile, FollowsLinks) {
  const test::Scratch scratch;
  scratch.write("real", "old");
  std::filesystem::create_symlink("real", scratch.path("link"));
  write_file(scratch.path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link")));
  EXPECT_EQ(test::bytes_of(scratch.path("real")), "new");
}

TEST(WriteFile, NamesTheFileAndTheReason) {
  const test::Scratch scratch;
  const auto error = [](const std::filesystem::path& file) {
    const std::string message = test::message_of([&] { write_file(file, "text"); });
    return message.substr(std::min(file.string().size(), message.size()));
  };
  EXPECT_EQ(error(scratch.path("no/a")),
            ": cannot be written (No such file or directory); make its folder first");
  std::filesystem::create_directory(scratch.path("folder"));
  EXPECT_EQ(error(scratch.path("folder")),
            ": cannot be written (Is a directory); name a file inside that folder");
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_EQ(error("/dev/full"),
              ": cannot be written (No space left on device); make room or name a file on another "
              "disk");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  }
}

/// Limits the size of files while it lives, as a full disk would.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(WriteFile, AFullDiskIsAnErrorAndLeavesNothingBehind) {
  const test::Scratch scratch;
  const Environment e = generate_environment("city", {5000, 1});
  for (const char* name : {"a.json", "a.cbor", "a.obj"}) {
    std::string message;
    {
      const SmallDisk disk(100000);
      message = test::message_of([&] { write_environment(e, scratch.path(name)); });
    }
    EXPECT_EQ(message, scratch.path(name).string() +
                           ": cannot be written (File too large); make room or name a file on "
                           "another disk");
    EXPECT_EQ(scratch.files(), 0u);
  }
  scratch.write("kept.json", "old");
  {
    const SmallDisk disk(10);
    EXPECT_THROW(write_file(scratch.path("kept.json"), std::string(11, 'x')), InputError);
  }
  EXPECT_EQ(test::bytes_of(scratch.path("kept.json")), "old");
  EXPECT_EQ(scratch.files(), 1u);
}

}  // namespace
}  // namespace cigsim
