// SPDX-License-Identifier: MIT
#include "models/machine/scale.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

double largest(const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

double largest(const std::vector<Vec3>& points) {
  double most = 0;
  for (const Vec3& p : points) most = std::max(most, largest(p));
  return most;
}

// How far from the environment's origin a moving system's coordinates can lie, an axis.
double reach(const PreparedSystem& system) {
  double position = largest(system.placement.position);
  for (const MotionKey& key : system.motion)
    position = std::max(position, largest(key.placement.position));
  const Vec3& c = system.sphere.centre;
  return position + std::hypot(c.x, c.y, c.z) + system.sphere.radius;
}

// To nearest, halves up. Beyond what a double counts in halves there is nothing to round.
double round_half_up(double value) {
  const double down = std::floor(value);
  return value - down >= 0.5 ? down + 1 : down;
}

}  // namespace

int coordinate_scale(const Database& database, const WordFormats& formats, double eye_reach) {
  // A little more than half, as the word of the limit itself would saturate.
  const double half_reach = eye_reach * (0.5 + 0x1p-20);
  double most = std::max(half_reach, largest(database.ground.vertices));
  for (std::size_t s = 0; s < database.systems.size(); ++s)
    most = std::max(
        most, s == 0 ? largest(database.systems[0].set.vertices) : reach(database.systems[s]));
  if (most == 0) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(most, &exponent);  // in [1/2, 1)
  return formats.coordinate_bits - 2 - exponent + (mantissa == 0.5 ? 1 : 0);
}

Word coordinate_word(double value, int scale, const WordFormats& formats,
                     std::uint64_t& overflows) {
  const double limit = std::ldexp(1, formats.coordinate_bits);  // well outside the word
  const double scaled = std::clamp(std::ldexp(value, scale), -limit, limit);
  return static_cast<Word>(saturate(static_cast<Accumulator>(round_half_up(scaled)),
                                    formats.coordinate_bits, overflows));
}

Word direction_word(double value, const WordFormats& formats) {
  const double rounded = round_half_up(std::ldexp(value, formats.direction_fraction));
  return static_cast<Word>(std::ldexp(rounded, kDirectionFraction - formats.direction_fraction));
}

ViewWords view_words(const ViewTransform& view, int scale, const WordFormats& formats,
                     std::uint64_t& overflows) {
  const double a = view.focal / (view.raster.width / 2.0);
  const double b = view.focal / (view.raster.height / 2.0);
  const double s = 1 / std::max({1.0, a, b});
  const double factor[3] = {s, s * a, s * b};
  ViewWords words;
  words.raster = view.raster;
  const double eye[3] = {view.eye.x, view.eye.y, view.eye.z};
  for (int i = 0; i < 3; ++i) {
    words.eye[i] = coordinate_word(eye[i], scale, formats, overflows);
    const Vec3& row = view.rotation.row[i];
    const double element[3] = {row.x, row.y, row.z};
    for (int j = 0; j < 3; ++j)
      words.matrix[i][j] = direction_word(factor[i] * element[j], formats);
  }
  return words;
}

}  // namespace cigsim
