// SPDX-License-Identifier: MIT
#include <cmath>

#include "models/environment/generators.hpp"
#include "models/environment/shapes.hpp"

namespace cigsim {
namespace {

constexpr double kLot = 32;     ///< a building and its share of the streets
constexpr double kAvenue = 16;  ///< additional width after every fourth lot

double lot_centre(std::uint32_t i) { return kLot * (i + 0.5) + kAvenue * (i / 4); }

/// Many low buildings and few towers, in quarters of a unit.
double height(Random& random) {
  const double u = random.unit();
  return std::floor(4 * (6 + 24 * u + 90 * u * u * u * u * u * u)) / 4;
}

Object building(const Vec3& centre, Random& random) {
  const Vec3 up{0, 0, height(random)};
  const bool turned = random.below(5) == 0;
  // A turned building stays inside its lot: half the diagonal of 20 by 20 is less than 16.
  const double most = turned ? 10 : 12;
  const double w = (most - 5) + random.below(21) * 0.25, d = (most - 5) + random.below(21) * 0.25;
  if (!turned) return box({centre.x - w, centre.y - d, 0}, {centre.x + w, centre.y + d, up.z});
  const double t = (1 + random.below(31)) / 32.0;
  const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  const Vec3 a = on_grid(Vec3{w * c, w * s, 0}), b = on_grid(Vec3{-d * s, d * c, 0});
  return prism({centre - a - b, centre + a - b, centre + a + b, centre - a + b}, up);
}

}  // namespace

void generate_city(Environment& environment, std::uint32_t objects, Random& random) {
  const std::uint32_t columns = root_up(objects, 2);
  for (std::uint32_t i = 0; i < objects; ++i) {
    const Vec3 centre{lot_centre(i % columns), lot_centre(i / columns), 0};
    Object& object = environment.objects.emplace_back(building(centre, random));
    object.name = "building " + std::to_string(i + 1);
  }
  const double low = -kLot, high = lot_centre(columns) + kLot;
  environment.ground.push_back(
      {{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}}, {96, 104, 88}});
}

}  // namespace cigsim
