// SPDX-License-Identifier: MIT
// Paths of the smallest steps.
#include "sim/stability/flicker.hpp"

#include <gtest/gtest.h>

namespace cigsim::stability {
namespace {

FlickerOptions options_of(std::vector<Format> formats) {
  FlickerOptions options;
  options.paths = 6;
  options.frames = 16;
  options.formats = std::move(formats);
  return options;
}

const Format kFloat{"float", Arithmetic::kFloat, {}};
const Format kCertified{"certified", Arithmetic::kCertified, {}};
const Format kExact{"exact", Arithmetic::kExact, {}};

TEST(Flicker, CertifiedAndExactPicturesNeverFlicker) {
  std::uint64_t changes = 0;
  for (const Flicker& f : measure_flicker(options_of({kCertified, kExact}))) {
    EXPECT_EQ(f.flickering, 0u) << f.format.name << ", steps of a " << name_of(f.step);
    EXPECT_EQ(f.wrong, 0u) << f.format.name << ", steps of a " << name_of(f.step);
    EXPECT_EQ(f.pairs, 6u * 15);
    changes += f.exact_changes;
  }
  // The paths lead over what they are meant to lead over.
  EXPECT_GT(changes, 0u);
}

TEST(Flicker, FloatFlickersAndIsFound) {
  std::uint64_t flickering = 0, wrong = 0;
  for (const Flicker& f : measure_flicker(options_of({kFloat}))) {
    flickering += f.flickering;
    wrong += f.wrong;
    EXPECT_LE(f.worst, f.flickering);
    EXPECT_LE(f.flickering_pairs, f.pairs);
  }
  EXPECT_GT(flickering, 0u);
  EXPECT_GT(wrong, 0u);
}

TEST(Flicker, WordsTooNarrowAreFound) {
  Format narrow{"narrow", Arithmetic::kMachine, machine_preset("nasa1968")};
  narrow.machine.formats = {16, 14, 12, 8};
  narrow.machine.hither = 1;
  std::uint64_t wrong = 0;
  for (const Flicker& f : measure_flicker(options_of({narrow}))) wrong += f.wrong;
  EXPECT_GT(wrong, 0u);
}

TEST(Flicker, TheSameSeedGivesTheSameFigures) {
  const auto once = measure_flicker(options_of({kFloat}));
  const auto twice = measure_flicker(options_of({kFloat}));
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].flickering, twice[i].flickering);
    EXPECT_EQ(once[i].wrong, twice[i].wrong);
  }
}

}  // namespace
}  // namespace cigsim::stability
