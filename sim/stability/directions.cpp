// SPDX-License-Identifier: MIT
#include "sim/stability/directions.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim::stability {

double length(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

double largest_coordinate(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Vec3 direction_of(const Vec3& v) {
  const double size = largest_coordinate(v);
  if (!(size > 0)) return {};
  const Vec3 scaled{v.x / size, v.y / size, v.z / size};
  return scaled * (1 / length(scaled));
}

Vec3 unit(const Vec3& v) {
  const Vec3 direction = direction_of(v);
  return direction == Vec3{} ? Vec3{1, 0, 0} : direction;
}

Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double size = length(d);
    if (size > 0.1 && size < 1) return d * (1 / size);
  }
}

}  // namespace cigsim::stability
