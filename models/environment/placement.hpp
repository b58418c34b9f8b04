// SPDX-License-Identifier: MIT
// Attitudes and placements as axes (conventions: heading clockwise from north, pitch up, roll
// right, degrees).
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "models/environment/environment.hpp"

namespace cigsim {

/// Sine of an angle in degrees; exact at every multiple of 90.
inline double sin_degrees(double degrees) {
  double r = std::remainder(degrees, 360.0);
  if (r > 90) r = 180 - r;
  if (r < -90) r = -180 - r;
  if (r == 90 || r == -90) return r / 90;
  return std::sin(r * std::numbers::pi / 180);
}
inline double cos_degrees(double degrees) {
  const double r = std::abs(std::remainder(degrees, 360.0));
  return sin_degrees(90 - r);
}

/// Rows u (ahead), v (right), w (up) of a body with this attitude, in environment axes.
inline Mat3 body_axes(const Placement& p) {
  const double sh = sin_degrees(p.heading), ch = cos_degrees(p.heading);
  const double sp = sin_degrees(p.pitch), cp = cos_degrees(p.pitch);
  const double sr = sin_degrees(p.roll), cr = cos_degrees(p.roll);
  const Vec3 ahead{sh * cp, ch * cp, sp}, right{ch, -sh, 0}, up{-sh * sp, -ch * sp, cp};
  return {{ahead, right * cr - up * sr, right * sr + up * cr}};
}

/// From a system's own axes (x right, y ahead, z up) into the environment's, one rounding an
/// operation. A placement without turn only adds.
class Placing {
 public:
  explicit Placing(const Placement& placement)
      : origin_(placement.position), axes_(body_axes(placement)) {}

  Vec3 operator()(const Vec3& p) const {
    return origin_ + (axes_.row[1] * p.x + axes_.row[0] * p.y + axes_.row[2] * p.z);
  }
  /// The environment's point in the system's own axes.
  Vec3 inverse(const Vec3& p) const {
    const Vec3 d = p - origin_;
    return {dot(axes_.row[1], d), dot(axes_.row[0], d), dot(axes_.row[2], d)};
  }

 private:
  Vec3 origin_;
  Mat3 axes_;
};

/// Points of a system as they lie in the environment's axes; to the bit as they are where the
/// placement is none.
inline std::vector<Vec3> placed(std::vector<Vec3> points, const Placement& placement) {
  if (placement == Placement{}) return points;
  const Placing place(placement);
  for (Vec3& p : points) p = place(p);
  return points;
}
inline Object placed(Object object, const Placement& placement) {
  object.vertices = placed(std::move(object.vertices), placement);
  return object;
}

/// Where the object's system stands, or begins to move.
inline const Placement& first_placement(const Environment& environment, const Object& object) {
  const CoordinateSystem& system =
      environment.systems.at(environment.models.at(object.model).system);
  return system.motion.empty() ? system.placement : system.motion.front().placement;
}

/// Angle a share t of the short way round from a to b, degrees.
inline double turn_towards(double a, double b, double t) {
  return a + std::remainder(b - a, 360.0) * t;
}

inline Placement interpolate(const Placement& a, const Placement& b, double t) {
  return {a.position + (b.position - a.position) * t, turn_towards(a.heading, b.heading, t),
          turn_towards(a.pitch, b.pitch, t), turn_towards(a.roll, b.roll, t)};
}

}  // namespace cigsim
