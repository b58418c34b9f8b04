// SPDX-License-Identifier: MIT
// The search for envelopes, the table that the program carries, and what it promises.
#include "sim/stability/envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/database/prepare.hpp"
#include "sim/stability/envelope_check.hpp"
#include "sim/stability/envelope_table.hpp"
#include "sim/stability/envelope_worlds.hpp"

namespace cigsim::stability {
namespace {

EnvelopeOptions coarse(std::vector<Format> formats) {
  EnvelopeOptions options;
  options.seed = kStoredSeed;
  options.views = 1;
  options.stride = 3;
  options.most_lines = 256;
  options.airfield = false;
  options.formats = std::move(formats);
  return options;
}

const std::vector<Envelope>& coarse_envelopes() {
  static const std::vector<Envelope> all = search_envelope(coarse(searched_formats()));
  return all;
}

const Envelope& named(const std::vector<Envelope>& all, const std::string& name) {
  for (const Envelope& e : all)
    if (e.format.name == name) return e;
  throw std::out_of_range(name);
}

TEST(EnvelopeSearch, FindsWhereFloatsBreak) {
  const Envelope& e = named(coarse_envelopes(), "float");
  for (const Quantity q :
       {Quantity::kClearance, Quantity::kSmallest, Quantity::kLargest, Quantity::kDemand}) {
    const EnvelopeLimit& limit = e.limit(q);
    ASSERT_TRUE(limit.failure && limit.value) << static_cast<int>(q);
    EXPECT_TRUE(limit.failure->faults.any());
    // Within some octaves of a plain error analysis.
    EXPECT_LT(std::abs(std::log2(*limit.value / *limit.predicted)), 10) << static_cast<int>(q);
  }
}

TEST(EnvelopeSearch, DoubleAndCertifiedFramesAreRightAsFarAsItLooks) {
  for (const char* name : {"double", "certified"}) {
    const Envelope& e = named(coarse_envelopes(), name);
    EXPECT_EQ(e.wrong, 0u) << name;
    for (const EnvelopeLimit& limit : e.limits) EXPECT_FALSE(limit.failure) << name;
  }
}

TEST(EnvelopeSearch, AWordTooNarrowIsFound) {
  Format narrow{"narrow", Arithmetic::kMachine, machine_preset("nasa1968")};
  narrow.machine.formats = {16, 14, 12, 8};
  narrow.machine.hither = 1;
  const std::vector<Envelope> found = search_envelope(coarse({narrow}));
  const Envelope& nasa = named(coarse_envelopes(), "nasa1968");
  EXPECT_GT(found[0].wrong, nasa.wrong);
  const EnvelopeLimit& limit = found[0].limit(Quantity::kDemand);
  ASSERT_TRUE(limit.failure);
  EXPECT_LT(limit.failure->value, nasa.limit(Quantity::kDemand).failure->value);
}

// The coarse search looks at some of the same frames.
TEST(EnvelopeTable, ACoarseSearchAgreesWithIt) {
  for (const Envelope& e : coarse_envelopes()) {
    const Envelope& stored = named(stored_envelopes(), e.format.name);
    for (const QuantityName& q : quantity_names()) {
      const EnvelopeLimit& found = e.limit(q.quantity);
      const EnvelopeLimit& promised = stored.limit(q.quantity);
      if (!found.failure) continue;
      ASSERT_TRUE(promised.failure) << e.format.name << " " << q.name;
      if (!promised.value) continue;
      if (q.least)
        EXPECT_LE(found.failure->value, *promised.value) << e.format.name << " " << q.name;
      else
        EXPECT_GE(found.failure->value, *promised.value) << e.format.name << " " << q.name;
    }
  }
}

TEST(EnvelopeTable, IsThatOfAllSearchedFormats) {
  ASSERT_EQ(stored_envelopes().size(), searched_formats().size());
  for (const Format& format : searched_formats()) {
    const Envelope& stored = named(stored_envelopes(), format.name);
    EXPECT_EQ(stored.format.arithmetic, format.arithmetic);
    EXPECT_EQ(stored.format.machine.formats, format.machine.formats);
    EXPECT_EQ(stored.format.machine.hither, format.machine.hither);
    EXPECT_GT(stored.frames, 1000u);
  }
}

TEST(EnvelopeTable, ComesBackFromJson) {
  const auto json = envelope_json(coarse_envelopes(), 1);
  EXPECT_EQ(envelope_json(envelopes_from_json(json), 1).dump(), json.dump());
}

// Frames inside of all limits at once are right, though each limit was found with the other axes
// at rest.
TEST(Envelope, FramesInsideOfAllLimitsAreRight) {
  const std::vector<SearchWorld> worlds = search_worlds(7, false);
  std::map<std::string, int> inside;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    SearchWorld world = worlds[random.below(worlds.size())];
    const double scale = std::exp2(random.between(-30, 30));
    const double offset = world.radius * scale * std::exp2(random.between(-4, 20));
    world = moved(world, scale, Vec3{offset, -offset / 2, offset / 4});
    const Database database = prepare(world.environment);
    const double distance = std::exp2(random.between(0.5, 12));
    Viewpoint viewpoint;
    const Vec3 direction{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Vec3 eye = world.centre + direction * (world.radius * distance);
    viewpoint.eye = look_at(eye, world.centre);
    viewpoint.fov = std::min(100.0, 100 / distance);
    const int lines = 16 << random.below(5);
    const ExactFrame frame(database, viewpoint, {lines, lines});
    if (frame.items().empty()) continue;
    for (const Envelope& envelope : stored_envelopes()) {
      const Format& format = envelope.format;
      const EnvelopeVerdict verdict = check_envelope(
          database, options_for(format, {lines, lines}, 0), {{viewpoint, 0}}, false, {envelope});
      ASSERT_TRUE(verdict.known) << format.name;
      if (!verdict.inside()) continue;
      ++inside[format.name];
      const FrameFaults faults = frame.judge(format);
      EXPECT_FALSE(faults.any()) << format.name << ": " << faults.elements << " elements, "
                                 << faults.distance << " from an edge, " << faults.priorities
                                 << " priorities, " << faults.facings << " facings";
    }
  }
  for (const Format& format : searched_formats()) EXPECT_GT(inside[format.name], 10) << format.name;
}

}  // namespace
}  // namespace cigsim::stability
