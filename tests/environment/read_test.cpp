// SPDX-License-Identifier: MIT
#include "models/environment/read.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

TEST(ReadEnvironment, WhatIsNoSceneFileSaysWhatToDo) {
  const test::Scratch scratch;
  const auto error = [&](const std::filesystem::path& file) {
    const std::string message = test::message_of([&] { read_environment(file); });
    return message.substr(std::min(file.string().size(), message.size()));
  };
  const std::string endings =
      "give a scene whose name ends in .json, .cbor, .deck, .cards, .obj, .ac, .gltf, .glb, .ply, "
      ".stl, "
      ".off or .3ds";
  EXPECT_EQ(error(scratch.write("a.txt", "x")), ": has the unknown ending .txt; " + endings);
  EXPECT_EQ(error(scratch.write("scene", "x")), ": has no ending; " + endings);
  EXPECT_EQ(error(scratch.path("")), ": is a folder; name a scene file inside it");
  EXPECT_EQ(error(scratch.path("no.txt")), ": no such file; check the name and the folder");
  std::filesystem::create_directory(scratch.path("folder.obj"));
  EXPECT_EQ(error(scratch.path("folder.obj")), ": is a folder; name a scene file inside it");
  for (const char* ending :
       {"json", "cbor", "deck", "obj", "ac", "gltf", "glb", "ply", "stl", "off", "3ds"}) {
    EXPECT_EQ(error(scratch.path(std::string("no.") + ending)),
              ": no such file; check the name and the folder");
    EXPECT_EQ(error(scratch.write(std::string("empty.") + ending, "")),
              ": is empty; write the scene again or name another file");
  }
}

TEST(ReadEnvironment, EndingsAreReadInEitherCase) {
  const test::Scratch scratch;
  const auto file = scratch.write("A.Obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read_environment(file).environment.objects.size(), 1u);
}

TEST(ReadEnvironment, EverySceneThatShipsIsRead) {
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(CIGSIM_SOURCE_DIR) / "scenes")) {
    const auto ending = entry.path().extension();
    if (ending != ".json" && ending != ".deck") continue;
    EXPECT_EQ(test::message_of([&] { read_environment(entry.path()); }), "nothing");
    ++scenes;
  }
  EXPECT_GT(scenes, 0);
}

}  // namespace
}  // namespace cigsim
