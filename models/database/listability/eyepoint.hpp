// SPDX-License-Identifier: MIT
// Witnesses: eyepoints with given sides at planes, in doubles where doubles reach them.
#pragma once

#include <optional>
#include <string>

#include "models/database/listability/arrangement.hpp"

namespace cigsim::listability {

struct Eyepoint {
  ExactVec exact;
  std::optional<Vec3> rounded;  ///< the same point, where it is one of doubles
};

/// The side at a plane, exactly; on the plane counts as TRUE.
inline bool eye_is_true(const Plane& plane, const Vec3& eye) { return side(plane, eye) >= 0; }
inline bool eye_is_true(const Plane& plane, const ExactVec& eye) { return side(plane, eye) >= 0; }

/// How far coordinates of the planes' points reach, at least 1.
double reach_of(const std::vector<Plane>& planes);

/// The roundest point of doubles near `exact` that has these sides, verified exactly; `exact`
/// itself, which must have them, where none was found.
Eyepoint eyepoint_near(const ExactVec& exact, const std::vector<Plane>& planes,
                       std::span<const EyeSide> sides);

/// X,Y,Z as the command takes it: doubles where there are, else fractions.
std::string text_of(const Eyepoint& eye);

}  // namespace cigsim::listability
