// SPDX-License-Identifier: MIT
// The extremes that decisions are driven to: along which axis, and how far.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/environment/random.hpp"

namespace cigsim::stability {

/// How an instance departs from a benign one: a thing of about one unit at the origin, in general
/// position, seen from a few units away.
struct Extremes {
  double scale = 1;   ///< what all lengths are multiplied by, in 1e-300..1e300
  double offset = 0;  ///< then everything is moved this far from the origin, environment units
  /// The point that a decision is about lies within so many ulps (of its largest coordinate) of
  /// where the decision changes; 0: there, as near as doubles come. None: anywhere.
  std::optional<double> ulps = {};
  /// Between planes that are near each other, radians; 0: coincident. None: any angle.
  std::optional<double> angle = {};
  double aspect = 1;  ///< width over length of faces and bodies, in (0, 1]
  /// Between a face's plane and the line from the eyepoint to it, radians. None: any angle.
  std::optional<double> grazing = {};
  double fov = 60;        ///< vertical, degrees
  double distance = 3;    ///< of the eyepoint from the thing, in sizes of the thing
  Raster raster{48, 48};  ///< that pictures are taken on
};

/// What a sweep changes; all else stays benign.
enum class Axis { kScale, kOffset, kNear, kParallel, kSliver, kEdgeOn, kFov, kDistance, kMixed };

inline constexpr std::array kAxes{Axis::kScale,    Axis::kOffset,   Axis::kNear,
                                  Axis::kParallel, Axis::kSliver,   Axis::kEdgeOn,
                                  Axis::kFov,      Axis::kDistance, Axis::kMixed};

/// "scale", "offset", "near", "parallel", "sliver", "edge-on", "fov", "distance", "mixed".
std::string_view name_of(Axis axis);
/// What its values are, with the unit.
std::string_view meaning_of(Axis axis);
/// The values of a sweep, in the order of a picture. Of kMixed one value, 0.
const std::vector<double>& values_of(Axis axis);
/// How far a value is from the benign one: the smaller of two is the less extreme. Of one axis
/// only.
double extremity(Axis axis, double value);
/// Benign but for one axis. kMixed takes `random`: a value of every other axis, drawn at random.
Extremes at(Axis axis, double value, Random& random);

}  // namespace cigsim::stability
