// SPDX-License-Identifier: MIT
// Whether pictures flicker: paths on which the eyepoint, or its heading, moves by one unit in the
// last place from frame to frame. From one frame to the next an element may change only where the
// exact picture changes too; one that changes by itself is seen to flicker.
//
// Paths begin where decisions hang on the last bit: beside a separation plane or the plane of a
// face, and straight across from edges, so that a column of samples lies on them. A step is one
// unit in the last place of a double, of a float (of 2^29 doubles, as a float does not see less),
// or of the machine's coordinate words.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/stability/decision.hpp"

namespace cigsim::stability {

enum class FlickerStep : std::uint8_t { kDouble, kFloat, kWord, kHeading };
std::string_view name_of(FlickerStep step);

struct FlickerOptions {
  std::uint64_t seed = 1;
  int paths = 12;   ///< of each kind of step
  int frames = 24;  ///< of a path, at least 2
  std::vector<Format> formats;
  std::function<void(double)> progress;
};

/// Of a format, over all paths of a kind of step.
struct Flicker {
  Format format;
  FlickerStep step = FlickerStep::kDouble;
  std::uint64_t pairs = 0;          ///< of frames that follow each other
  std::uint64_t exact_changes = 0;  ///< elements of the exact pictures that changed
  std::uint64_t flickering = 0;     ///< elements that changed where the exact picture did not
  std::uint64_t flickering_pairs = 0;
  std::uint64_t worst = 0;  ///< most in one pair
  std::uint64_t wrong = 0;  ///< elements that differ from the exact picture
};

/// By kind of step, in the order of the formats. Deterministic.
std::vector<Flicker> measure_flicker(const FlickerOptions& options);

}  // namespace cigsim::stability
