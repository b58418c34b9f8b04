// SPDX-License-Identifier: MIT
// The data sets of Levine 1975 (Fig. 6.9 and its list): unit cubes centred on a lattice of pitch 3.
#include "models/environment/generators.hpp"
#include "models/environment/shapes.hpp"

namespace cigsim {
namespace {

/// Lattice place of cube i in Levine's order: 4 cubes about the origin in x and z, 8 with y = 3, 16
/// with x = 6 and 9, 24 with z = 6, 32 with z = 9, and on with y = 6 and 9 up to 64.
Vec3 nested_place(std::uint32_t i) {
  if (i < 8) return {double(i & 1), double(i >> 2 & 1), double(i >> 1 & 1)};
  if (i < 16) return {double(2 + (i & 1)), double(i >> 2 & 1), double(i >> 1 & 1)};
  const auto layer = [](std::uint32_t k) { return Vec3{double(k & 3), double(k >> 2 & 1), 0}; };
  if (i < 32) return layer(i & 7) + Vec3{0, 0, double(i >> 3)};
  return layer(i & 7) + Vec3{0, 2, double(i >> 3 & 3)};
}

Vec3 place(std::uint32_t i, std::uint32_t objects) {
  // The set of 48 has the layers z = 0, 3, 6 at every y.
  if (objects == 48 && i >= 24) return place(i - 24, 24) + Vec3{0, 2, 0};
  if (objects <= 64) return nested_place(i);
  const std::uint32_t m = root_up(objects, 3);
  return {double(i % m), double(i / m % m), double(i / m / m)};
}

}  // namespace

void generate_cubes(Environment& environment, std::uint32_t objects, Random&) {
  for (std::uint32_t i = 0; i < objects; ++i) {
    const Vec3 centre = place(i, objects) * 3;
    const Vec3 half{0.5, 0.5, 0.5};
    Object& object = environment.objects.emplace_back(box(centre - half, centre + half));
    object.name = "cube " + std::to_string(i + 1);
  }
}

}  // namespace cigsim
