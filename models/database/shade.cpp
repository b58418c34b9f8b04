// SPDX-License-Identifier: MIT
#include "models/database/shade.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cigsim {

Colour palette_colour(std::uint32_t number) {
  // Hues a golden section apart never repeat and are far apart for neighbours.
  const double hue = std::fmod(number * 0.6180339887498949, 1.0) * 6;
  const double x = 1 - std::abs(std::fmod(hue, 2) - 1);
  const double table[6][3] = {{1, x, 0}, {x, 1, 0}, {0, 1, x}, {0, x, 1}, {x, 0, 1}, {1, 0, x}};
  const auto& c = table[static_cast<int>(hue) % 6];
  const auto level = [](double v) { return static_cast<std::uint8_t>(std::lround(90 + 140 * v)); };
  return {level(c[0]), level(c[1]), level(c[2])};
}

Vec3 towards(const Sun& sun) {
  const double a = sun.azimuth * std::numbers::pi / 180, e = sun.elevation * std::numbers::pi / 180;
  return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

Colour shaded(Colour colour, const Vec3& normal, const Vec3& sun) {
  const double length = std::hypot(normal.x, normal.y, normal.z);
  if (!(length > 0) || !std::isfinite(length)) return colour;
  const double cosine = std::clamp(dot(normal, sun) / length, 0.0, 1.0);
  const double share = 0.4 + 0.6 * cosine;
  const auto level = [share](std::uint8_t v) {
    return static_cast<std::uint8_t>(std::lround(v * share));
  };
  return {level(colour.r), level(colour.g), level(colour.b)};
}

}  // namespace cigsim
