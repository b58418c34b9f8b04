// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "models/environment/read.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

const std::string kScene = R"({
 "cigsim": 1,
 "name": "two",
 "background": [1, 2, 3],
 "view": {"eye": [0, -10, 5], "look_at": [0, 0, 5], "fov": 45},
 "sun": {"azimuth": 180, "elevation": 30},
 "objects": [
  {"name": "first", "colour": [9, 8, 7],
   "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
   "faces": [
    [0, 2, 1],
    {"vertices": [0, 1, 3], "colour": [255, 0, 0]}
   ]}
 ],
 "systems": [
  {"name": "mover",
   "motion": [{"frame": 0, "position": [1, 2, 3]},
              {"frame": 10, "position": [4, 5, 6], "attitude": [90, 0, 0]}],
   "models": [{"name": "plane", "objects": [
     {"name": "second", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]}]}]}
 ],
 "ground": [{"vertices": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]], "colour": [0, 100, 0]}]
}
)";

/// The scene with `from` replaced by `to`.
std::string with(const std::string& from, const std::string& to) {
  std::string text = kScene;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& text) {
  return test::message_of([&] { parse_json(text, "s.json"); });
}

TEST(JsonReader, ReadsEveryPartOfAScene) {
  const Environment e = parse_json(kScene, "s.json").environment;
  EXPECT_EQ(e.name, "two");
  EXPECT_EQ(e.background, (Colour{1, 2, 3}));
  ASSERT_TRUE(e.view);
  EXPECT_EQ(e.view->eye, (Placement{{0, -10, 5}, 0, 0, 0}));
  EXPECT_EQ(e.view->fov, 45);
  EXPECT_EQ(e.sun, (Sun{180, 30}));
  ASSERT_EQ(e.objects.size(), 2u);
  EXPECT_EQ(e.objects[0].faces[0], (Face{{0, 2, 1}, Colour{9, 8, 7}}));
  EXPECT_EQ(e.objects[0].faces[1], (Face{{0, 1, 3}, Colour{255, 0, 0}}));
  EXPECT_EQ(e.objects[1].faces[0], (Face{{0, 1, 2}, std::nullopt}));
  ASSERT_EQ(e.models.size(), 2u);
  EXPECT_EQ(e.models[0], (Model{"", 0}));
  EXPECT_EQ(e.models[1], (Model{"plane", 1}));
  EXPECT_EQ(e.objects[1].model, 1u);
  ASSERT_EQ(e.systems.size(), 2u);
  ASSERT_EQ(e.systems[1].motion.size(), 2u);
  EXPECT_EQ(e.systems[1].motion[1], (MotionKey{10, {{4, 5, 6}, 90, 0, 0}}));
  ASSERT_EQ(e.ground.size(), 1u);
  EXPECT_EQ(e.ground[0].colour, (Colour{0, 100, 0}));
}

TEST(JsonReader, LookAtBecomesHeadingAndPitch) {
  const auto look = [](const std::string& at) {
    return parse_json(with("\"look_at\": [0, 0, 5]", "\"look_at\": " + at), "s")
        .environment.view->eye;
  };
  EXPECT_DOUBLE_EQ(look("[10, -10, 5]").heading, 90);
  EXPECT_DOUBLE_EQ(look("[-10, -10, 5]").heading, -90);
  EXPECT_DOUBLE_EQ(look("[0, 0, 15]").pitch, 45);
  EXPECT_DOUBLE_EQ(look("[0, -10, 0]").pitch, -90);
}

TEST(JsonReader, ObjectNumbersFollowTheText) {
  const Environment e = parse_json(R"({"cigsim": 1,
    "models": [{"name": "a"}, {"name": "b", "system": 1}], "systems": [{"name": "s"}],
    "objects": [{"model": 1, "vertices": [[0,0,0],[1,0,0],[0,1,0]], "faces": [[0,1,2]]},
                {"model": 0, "vertices": [[0,0,0],[1,0,0],[0,1,0]], "faces": [[0,1,2]]}]})",
                                   "s")
                            .environment;
  EXPECT_EQ(e.objects[0].model, 1u);
  EXPECT_EQ(e.objects[1].model, 0u);
  EXPECT_EQ(e.models[1].system, 1u);
}

TEST(JsonReader, GroundAloneIsAScene) {
  const Environment e = parse_json(R"({"cigsim": 1, "ground": [
    {"vertices": [[0,0,0],[1,0,0],[0,1,0]], "colour": [1,2,3]}]})",
                                   "s")
                            .environment;
  EXPECT_TRUE(e.objects.empty());
  EXPECT_EQ(e.ground.size(), 1u);
}

TEST(JsonReader, EveryFaultOfTheContentsIsNamedWithItsLine) {
  const struct {
    std::string from, to, message;
  } cases[] = {
      {"\"cigsim\": 1", "\"cigsim\": 2", "s.json:2: this version of the scene format is unknown"},
      {"\"cigsim\": 1", "\"cigsim\": \"1\"", "s.json:2: this version of the scene format"},
      {" \"cigsim\": 1,\n", "", "s.json:1: is no cigsim scene: key \"cigsim\" is missing"},
      {"\"name\": \"two\"", "\"nmae\": \"two\"",
       "s.json:3: unknown key \"nmae\" in the scene; it takes cigsim, name,"},
      {"\"name\": \"two\"", "\"name\": 2", "s.json:3: a name must be a text, not a number"},
      {"\"name\": \"two\"", "\"cigsim\": 1", "s.json:3: key \"cigsim\" stands twice in the scene"},
      {"[1, 2, 3]", "[1, 2, 256]", "s.json:4: the background must be a whole number from 0 to 255"},
      {"[1, 2, 3]", "[1, 2]", "s.json:4: the background must have 3 numbers, not 2"},
      {"\"fov\": 45", "\"fov\": 180", "s.json:5: fov must lie between 0 and 180 degrees"},
      {"\"fov\": 45", "\"fov\": 0", "s.json:5: fov must lie between 0 and 180 degrees"},
      {"\"look_at\": [0, 0, 5]", "\"look_at\": [0, -10, 5]", "s.json:5: look_at is the eye itself"},
      {"\"fov\": 45", "\"attitude\": [0, 0, 0]",
       "s.json:5: the view has both look_at and attitude"},
      {"[1, 0, 0], [0, 1, 0], [0, 0, 1]", "[1, 0], [0, 1, 0], [0, 0, 1]",
       "s.json:9: a vertex must have 3 numbers, not 2"},
      {"[1, 0, 0], [0, 1, 0], [0, 0, 1]", "[1, null, 0], [0, 1, 0], [0, 0, 1]",
       "s.json:9: a vertex must be a number, not null"},
      {"[0, 2, 1]", "[0, 2]", "s.json:11: a face needs at least 3 different vertices, not 2"},
      {"[0, 2, 1]", "[0, 2, 0, 2]", "s.json:11: a face needs at least 3 different vertices, not 2"},
      {"[0, 2, 1]", "[0, 2, 4]",
       "s.json:11: a vertex of a face must be a whole number from 0 to 3"},
      {"[0, 2, 1]", "[0, 2, -1]",
       "s.json:11: a vertex of a face must be a whole number from 0 to 3"},
      {"[0, 2, 1]", "[0,\n 2,\n 1.5\n]", "s.json:13: a vertex of a face must be a whole number"},
      {"\"colour\": [255, 0, 0]", "\"color\": [255, 0, 0]",
       "s.json:12: unknown key \"color\" in a face; it takes vertices, colour"},
      {"\"frame\": 10", "\"frame\": 0", "s.json:18: frames of a motion must ascend"},
      {"\"motion\": [{", "\"placement\": {}, \"motion\": [{",
       "s.json:17: a system has both placement and motion"},
      {"\"vertices\": [[-9, -9, 0], ", "\"vertices\": [",
       "s.json:22: a ground face needs at least 3 vertices, not 2"},
  };
  for (const auto& c : cases) {
    const std::string message = error_of(with(c.from, c.to));
    EXPECT_EQ(message.substr(0, c.message.size()), c.message);
  }
}

TEST(JsonReader, FaultsOfReferencesAreNamedWithTheirLine) {
  const std::string object = R"({"model": 3, "vertices": [], "faces": []})";
  EXPECT_EQ(error_of("{\"cigsim\": 1,\n\"models\": [{}],\n\"objects\": [" + object + "]}"),
            "s.json:3: there is no model 3; the scene has 1, counted from 0");
  EXPECT_EQ(error_of("{\"cigsim\": 1,\n\"models\": [{\n\"system\": 1}]}"),
            "s.json:3: there is no system 1; the last is 0 (0 is the environment itself)");
}

TEST(JsonReader, ASeparationTableIsRead) {
  const Environment e = parse_json(with(" \"ground\"", R"( "separation": [
  {"normal": [0, 0.5, -1], "distance": -2.5, "pairs": [[2, 1]]}],
 "ground")"),
                                   "s.json")
                            .environment;
  const std::vector<SeparationPlane> want{{{0, 0.5, -1}, -2.5, {{2, 1}}}};
  EXPECT_EQ(e.separation, want);
  EXPECT_TRUE(parse_json(kScene, "s.json").environment.separation.empty());
}

TEST(JsonReader, FaultsOfASeparationTableAreNamedWithTheirLine) {
  const auto fault = [](const std::string& table) {
    return error_of(with(" \"ground\"", " \"separation\":\n" + table + ",\n \"ground\""));
  };
  const std::string plane = "[{\"normal\": [1, 0, 0], \"distance\": 0,\n \"pairs\": ";
  const std::vector<std::pair<std::string, std::string>> faults{
      {"[]", "s.json:23: the separation has no plane"},
      {"[{\"normal\": [0, 0, 0], \"distance\": 0, \"pairs\": [[1, 2]]}]",
       "s.json:23: the normal of a separation plane is zero"},
      {"[{\"distance\": 0, \"pairs\": [[1, 2]]}]", "s.json:23: key \"normal\" is missing"},
      {"[{\"normal\": [1, 0, 0], \"pairs\": [[1, 2]]}]", "s.json:23: key \"distance\" is missing"},
      {plane + "[]}]", "s.json:24: a separation plane has no pairs"},
      {plane + "[[1]]}]", "s.json:24: a pair must be [TRUE object, FALSE object], not 1"},
      {plane + "[[1, 2, 1]]}]", "s.json:24: a pair must be [TRUE object, FALSE object], not 3"},
      {plane + "[[1, -2]]}]", "s.json:24: an object's number must be a whole number"},
      {plane + "[[1, 0]]}]", "s.json:24: pair 1, 0 names an object that is not there"},
      {plane + "[[1, 3]]}]", "s.json:24: pair 1, 3 names an object that is not there"},
      {plane + "[[2, 2]]}]", "s.json:24: pair 2, 2 is one object"},
      {plane + "[[1, 2],\n[2, 1]]}]", "s.json:25: pair 2, 1 stands twice"}};
  for (const auto& [table, message] : faults)
    EXPECT_EQ(fault(table).substr(0, message.size()), message) << table;
}

TEST(JsonReader, WhatIsNoJsonIsNamedWithItsLine) {
  EXPECT_EQ(error_of("{\n\"cigsim\": 1,\n}").substr(0, 24), "s.json:3: not valid JSON");
  EXPECT_EQ(error_of("{\"cigsim\": 1,\n\"sun\": {\"azimuth\": NaN}}").substr(0, 24),
            "s.json:2: not valid JSON");
  EXPECT_EQ(error_of("{\"cigsim\": 1,\n\"sun\": {\"azimuth\": 1e999}}").substr(0, 9), "s.json:2:");
  EXPECT_EQ(error_of("[1]"), "s.json:1: the scene must be an object {}, not an array []");
  EXPECT_EQ(error_of("{\"cigsim\": 1, \"objects\": []}"),
            "s.json:1: holds no object and no ground; add \"objects\" or \"ground\"");
  EXPECT_NE(error_of(std::string(100000, '[')).find("nested more than 64 deep"), std::string::npos);
}

TEST(JsonReader, EveryTruncationIsAnError) {
  for (std::size_t n = 0; n + 2 < kScene.size(); ++n)
    ASSERT_NE(error_of(kScene.substr(0, n)), "nothing") << n;
}

TEST(CborReader, HandWrittenDocumentIsRead) {
  // RFC 8949: a map of two pairs: "cigsim": 1, "ground": [{"vertices": [...], "colour": [...]}].
  // Coordinates in half precision (f9), single (fa), double (fb), whole (0x) and negative (2x).
  const std::string bytes =
      std::string(
          "\xa2\x66"
          "cigsim\x01\x66"
          "ground\x81\xa2\x68"
          "vertices\x83") +
      std::string("\x83\x00\x00\x00", 4) +
      std::string("\x83\xf9\x3c\x00\x20\xfa\x3f\xc0\x00\x00", 10) +
      std::string("\x83\xfb\x3f\xe0\x00\x00\x00\x00\x00\x00\x18\x64\x00", 13) +
      "\x66"
      "colour\x83\x01\x02\x18\xff";
  const test::Scratch scratch;
  const Environment e = read_environment(scratch.write("a.CBOR", bytes)).environment;
  ASSERT_EQ(e.ground.size(), 1u);
  EXPECT_EQ(e.ground[0].vertices[1], (Vec3{1, -1, 1.5}));
  EXPECT_EQ(e.ground[0].vertices[2], (Vec3{0.5, 100, 0}));
  EXPECT_EQ(e.ground[0].colour, (Colour{1, 2, 255}));
  for (std::size_t n = 1; n < bytes.size(); ++n) {
    const auto file = scratch.write("cut.cbor", bytes.substr(0, n));
    EXPECT_EQ(test::message_of([&] { read_environment(file); }).find(file.string() + ": "), 0u);
  }
}

TEST(CborReader, NotANumberAndDeepNestingAreErrors) {
  const test::Scratch scratch;
  const auto error = [&](const std::string& bytes) {
    const auto file = scratch.write("a.cbor", bytes);
    return test::message_of([&] { read_environment(file); });
  };
  const std::string nan(
      "\xa2\x66"
      "cigsim\x01\x63"
      "sun\xa1\x67"
      "azimuth\xf9\x7e\x00",
      25);
  EXPECT_NE(error(nan).find("an azimuth must be a finite number"), std::string::npos) << error(nan);
  EXPECT_NE(error(std::string(1000000, '\x81')).find("nested more than 64"), std::string::npos);
  EXPECT_NE(error("\x41"
                  "a")
                .find("binary data"),
            std::string::npos);
}

}  // namespace
}  // namespace cigsim
