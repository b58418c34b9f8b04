// SPDX-License-Identifier: MIT
#include "models/database/listability/eyepoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cigsim::listability {
namespace {

constexpr int kGrids = 64;  // from the size of the point down to 2^-63 of it

bool has_sides(const std::vector<Plane>& planes, std::span<const EyeSide> sides, const Vec3& eye) {
  return std::all_of(sides.begin(), sides.end(), [&](const EyeSide& s) {
    return eye_is_true(planes[s.plane], eye) == s.eye_true;
  });
}

}  // namespace

double reach_of(const std::vector<Plane>& planes) {
  double reach = 1;
  for (const Plane& plane : planes)
    for (const Vec3* v : {&plane.exact.p, &plane.exact.u0, &plane.exact.v0})
      reach = std::max({reach, std::abs(v->x), std::abs(v->y), std::abs(v->z)});
  return reach;
}

Eyepoint eyepoint_near(const ExactVec& exact, const std::vector<Plane>& planes,
                       std::span<const EyeSide> sides) {
  Eyepoint eye{exact, std::nullopt};
  const Vec3 near{exact.x.get_d(), exact.y.get_d(), exact.z.get_d()};
  const double size = std::max({std::abs(near.x), std::abs(near.y), std::abs(near.z)});
  if (!std::isfinite(size)) return eye;
  int exponent = 0;
  std::frexp(size, &exponent);
  for (int g = 0; g < kGrids && size > 0; ++g) {
    const double grid = std::ldexp(1.0, exponent - g);
    const auto round = [&](double value) { return std::nearbyint(value / grid) * grid + 0.0; };
    const Vec3 rounded{round(near.x), round(near.y), round(near.z)};
    if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y) || !std::isfinite(rounded.z))
      continue;
    if (!has_sides(planes, sides, rounded)) continue;
    return {convert<Exact>(rounded), rounded};
  }
  return has_sides(planes, sides, near) ? Eyepoint{convert<Exact>(near), near} : eye;
}

std::string text_of(const Eyepoint& eye) {
  if (eye.rounded) return fmt::format("{},{},{}", eye.rounded->x, eye.rounded->y, eye.rounded->z);
  return eye.exact.x.get_str() + "," + eye.exact.y.get_str() + "," + eye.exact.z.get_str();
}

}  // namespace cigsim::listability
