// SPDX-License-Identifier: MIT
// Scenes held against the envelope of the numbers that they are to be computed in.
#include "sim/stability/envelope_check.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "sim/embedded.hpp"
#include "sim/path.hpp"
#include "sim/stability/envelope_table.hpp"
#include "sim/stability/envelope_worlds.hpp"

namespace cigsim::stability {
namespace {

const Format kFloat{"float", Arithmetic::kFloat, {}};
const Format kDouble{"double", Arithmetic::kDouble, {}};

Format preset(const char* name) { return {name, Arithmetic::kMachine, machine_preset(name)}; }

EnvelopeVerdict check(const Database& database, const Format& format, const Viewpoint& viewpoint,
                      const Raster& raster, bool words_only = false) {
  return check_envelope(database, options_for(format, raster, 0), {{viewpoint, 0}}, words_only,
                        stored_envelopes());
}

SearchWorld city() { return search_worlds(1, false)[2]; }

// South of the middle of the world, above it, looking at it.
Viewpoint view_of(const SearchWorld& world, double distance) {
  const Vec3 eye = world.centre + Vec3{0.13, -0.8, 0.59} * (world.radius * distance);
  return {look_at(eye, world.centre), 60};
}

TEST(EnvelopeCheck, AnEarthRadiusFromTheOriginIsTooMuchForFloat) {
  const SearchWorld world = moved(city(), 0.01, {6.4e6, 0, 0});
  const Database database = prepare(world.environment);
  const Viewpoint viewpoint = view_of(world, 1.2);
  const Raster raster{256, 256};
  const EnvelopeVerdict verdict = check(database, kFloat, viewpoint, raster);
  ASSERT_FALSE(verdict.inside());
  EXPECT_EQ(verdict.will_do, "--number double");
  const std::string warning = envelope_warning(verdict);
  EXPECT_NE(warning.find("outside the envelope of float"), std::string::npos) << warning;
  EXPECT_NE(warning.find("demand"), std::string::npos) << warning;
  EXPECT_NE(warning.find("--number double will do"), std::string::npos) << warning;
  EXPECT_EQ(warning.find('\n'), std::string::npos);

  // And so it is: the picture is really wrong in float, and right in double.
  const ExactFrame frame(database, viewpoint, raster);
  EXPECT_TRUE(frame.judge(kFloat).any());
  EXPECT_TRUE(check(database, kDouble, viewpoint, raster).inside());
  EXPECT_FALSE(frame.judge(kDouble).any());
}

TEST(EnvelopeCheck, TheSameAtTheOriginIsNot) {
  const SearchWorld world = city();
  const Database database = prepare(world.environment);
  const EnvelopeVerdict verdict = check(database, kFloat, view_of(world, 1.2), {256, 256});
  EXPECT_TRUE(verdict.known);
  EXPECT_TRUE(verdict.inside()) << envelope_warning(verdict);
  EXPECT_EQ(envelope_warning(verdict), "");
  EXPECT_EQ(verdict.frames_checked, 1u);
}

TEST(EnvelopeCheck, AScaleAtWhichWordsOfAnOldMachineFail) {
  // A thing of a thousandth in a world of a hundred thousand, seen from near by.
  Environment environment = generate_environment("cubes", {4, 1});
  for (Object& object : environment.objects)
    for (Vec3& v : object.vertices) v = v * 1e-3;
  GroundFace ground;
  ground.vertices = {{-1e5, -1e5, -1}, {1e5, -1e5, -1}, {1e5, 1e5, -1}, {-1e5, 1e5, -1}};
  environment.ground = {ground};
  const Database database = prepare(environment);
  const Viewpoint viewpoint{look_at({0.004, -0.012, 0.006}, {0.001, 0.001, 0.0005}), 60};
  const EnvelopeVerdict verdict = check(database, preset("nasa1968"), viewpoint, {128, 128});
  ASSERT_FALSE(verdict.inside());
  EXPECT_TRUE(ExactFrame(database, viewpoint, {128, 128}).judge(preset("nasa1968")).any());
  EXPECT_EQ(verdict.will_do, "--number double");
  // Where stages need words there is no way out but another level.
  const EnvelopeVerdict words = check(database, preset("nasa1968"), viewpoint, {128, 128}, true);
  EXPECT_FALSE(words.will_do);
  EXPECT_NE(envelope_warning(words).find("--level functional"), std::string::npos);
}

TEST(EnvelopeCheck, AnEyepointInASlantedPlaneIsTooMuchForFloat) {
  const Database database = prepare(search_worlds(1, false)[0].environment);
  const FaceSet& set = database.systems[0].set;
  const PreparedFace& face = set.faces[0];
  const auto corner = [&](std::uint32_t c) {
    return set.vertices[set.items[0].first_vertex + set.corners[face.first_corner + c]];
  };
  // On an edge of the face, prolonged.
  const Vec3 eye = corner(0) + (corner(1) - corner(0)) * 7;
  const Viewpoint viewpoint{look_at(eye, corner(0)), 60};
  const EnvelopeVerdict verdict = check(database, kFloat, viewpoint, {64, 64});
  ASSERT_FALSE(verdict.inside());
  EXPECT_EQ(verdict.excesses[0].quantity, Quantity::kClearance);
  EXPECT_TRUE(check(database, kDouble, viewpoint, {64, 64}).inside());
}

TEST(EnvelopeCheck, AnEyepointLevelWithARoofIsNot) {
  const Database database = prepare(generate_environment("cubes", {8, 1}));
  const Viewpoint viewpoint{look_at({0.5, -7, 1}, {0.5, 0, 0.5}), 60};
  for (const Format& format : searched_formats()) {
    const EnvelopeVerdict verdict = check(database, format, viewpoint, {64, 64});
    EXPECT_TRUE(verdict.inside()) << envelope_warning(verdict);
    EXPECT_FALSE(ExactFrame(database, viewpoint, {64, 64}).judge(format).any()) << format.name;
  }
}

TEST(EnvelopeCheck, AMachineIsHeldToItsOwnRowAmongThoseOfEqualWidths) {
  const SearchWorld world = city();
  const Database database = prepare(world.environment);
  for (const char* name : {"nasa1968", "asupt1975", "unlimited"}) {
    MachineOptions options = options_for(preset(name), {64, 64}, 0);
    options.description.name = name;
    EXPECT_EQ(
        check_envelope(database, options, {{view_of(world, 1.2), 0}}, true, stored_envelopes())
            .format,
        name);
  }
}

TEST(EnvelopeCheck, OtherWordsTakeTheWidestRowThatIsNowhereWider) {
  const SearchWorld world = city();
  const Database database = prepare(world.environment);
  Format own = preset("asupt1975");
  own.machine.formats.quotient_fraction = 20;
  EXPECT_EQ(check(database, own, view_of(world, 2), {64, 64}).format, "nasa1968");
  own.machine.formats = {};
  EXPECT_NE(check(database, own, view_of(world, 2), {64, 64}).format, "nasa1968");
  own.machine.formats = {16, 12, 8, 4};
  const EnvelopeVerdict unknown = check(database, own, view_of(world, 2), {64, 64});
  EXPECT_FALSE(unknown.known);
  EXPECT_TRUE(unknown.inside());
  EXPECT_TRUE(envelope_verdict_json(unknown)["format"].is_null());
}

TEST(EnvelopeCheck, NothingInViewIsInside) {
  const Database empty = prepare(Environment());
  for (const Format& format : searched_formats()) {
    const EnvelopeVerdict verdict = check(empty, format, {}, {64, 64});
    EXPECT_TRUE(verdict.inside()) << format.name << ": " << envelope_warning(verdict);
    EXPECT_NO_THROW(envelope_verdict_json(verdict).dump());
  }
}

TEST(EnvelopeCheck, ShippedScenesAreInsideWithDoubles) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CIGSIM_SOURCE_DIR "/scenes")) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".json" && ending != ".deck") continue;
    const Database database = prepare(read_environment(entry.path()).environment);
    const Viewpoint viewpoint{database.view.eye, database.view.fov};
    const EnvelopeVerdict verdict = check(database, kDouble, viewpoint, {1024, 1024});
    EXPECT_TRUE(verdict.known && verdict.inside())
        << entry.path() << ": " << envelope_warning(verdict);
    ++scenes;
  }
  EXPECT_GT(scenes, 10u);
}

TEST(EnvelopeCheck, TheApproachIsInsideOnTheWordsOfItsTime) {
  const auto text = [](const char* name) { return embedded_text(embedded_scenes(), name); };
  const Database database = prepare(parse_json(text("airfield.json"), "airfield").environment);
  const std::vector<PathRow> path = parse_path(text("airfield-approach.csv"), "approach");
  ViewOptions view;
  view.frames = 20;
  const std::vector<FrameView> views = frame_views(view, path, database);
  MachineOptions options = options_for(preset("asupt1975"), {256, 256}, eye_reach(views));
  const EnvelopeVerdict verdict =
      check_envelope(database, options, views, true, stored_envelopes());
  EXPECT_EQ(verdict.frames_checked, 20u);
  EXPECT_TRUE(verdict.inside()) << envelope_warning(verdict);
}

// Worked by hand: a square of side 2 before the eyepoint, 3 units away.
TEST(Measures, OfASquareBeforeTheEyepoint) {
  Environment environment;
  environment.models.push_back({"model", 0});
  Object square;
  square.vertices = {{-1, 3, -1}, {1, 3, -1}, {1, 3, 1}, {-1, 3, 1}};
  square.faces = {{{0, 1, 2, 3}, {}}};
  environment.objects = {square};
  const Database database = prepare(environment);
  const ExactFrame frame(database, {{{0, 0, 0}, 0, 0, 0}, 90}, {100, 80});
  const Measures m = frame.measures();
  EXPECT_EQ(m.lines, 100);
  EXPECT_NEAR(m.smallest, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(m.largest, 3 + std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(m.nearness, 3 / m.largest, 1e-9);
  EXPECT_NEAR(m.clearance, 3 / m.largest, 1e-9);
  EXPECT_NEAR(m.demand, m.largest / 3 * 40, 1e-6);
}

}  // namespace
}  // namespace cigsim::stability
