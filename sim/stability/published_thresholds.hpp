// SPDX-License-Identifier: MIT
// Stump's separation program as he published it (Stump 1986, ch. III and IV), driven to its
// extremes: a vertex within 0.001 of a plane is on neither side of it, whatever the scale; and a
// plane comes of a face's first three vertices, however near to each other they are. The program is
// models/database/separation_planes/published.hpp, as it stands; beside it the same planes with
// exact sides, and the tables that `cigsim separate` finds.
//
// A deck is a row of prisms, turned at random, that do not meet. Along the first axis everything is
// multiplied by a scale; along the second the first three vertices of each base draw together, to a
// share of their usual distance.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace cigsim::stability {

enum class ThresholdAxis : std::uint8_t { kScale, kSliver };
std::string_view name_of(ThresholdAxis axis);

struct ThresholdOptions {
  std::uint64_t seed = 1;
  int decks = 10;   ///< at each value
  int objects = 4;  ///< of a deck, 2..8
  std::function<void(double)> progress;
};

/// What became of the decks at one value. A decision is a plane of a face with an object that the
/// face does not belong to: wholly on a side, or cut.
struct ThresholdPoint {
  ThresholdAxis axis = ThresholdAxis::kScale;
  double value = 0;
  std::uint64_t decks = 0, refused = 0;  ///< refused: his program divides by zero
  std::uint64_t decisions = 0;
  std::uint64_t wrong_sides = 0;  ///< whole, but told to lie on the other side
  std::uint64_t missed_cuts = 0;  ///< cut, but told to be whole
  std::uint64_t false_cuts = 0;   ///< whole, but told to be cut
  std::uint64_t faces = 0;
  std::uint64_t own_cut = 0;  ///< faces whose plane is told to cut their own, convex, object
  /// Tables: that his program found; of these, those whose planes part all their pairs (no vertex
  /// further than 2^-30 of the deck's size on the wrong side); that exact sides found, and of
  /// these the right ones.
  std::uint64_t found = 0, right = 0, exact_found = 0, exact_right = 0;

  std::uint64_t wrong() const { return wrong_sides + missed_cuts + false_cuts; }
};

/// The values of an axis: scales 1e-12..1e12, shares 1..1e-12.
std::vector<double> threshold_values(ThresholdAxis axis);

/// All values of both axes. Deterministic.
std::vector<ThresholdPoint> measure_thresholds(const ThresholdOptions& options);

}  // namespace cigsim::stability
