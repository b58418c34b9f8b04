// SPDX-License-Identifier: MIT
#include "models/environment/generators.hpp"
#include "models/environment/shapes.hpp"

namespace cigsim {
namespace {

/// Places stand 8 apart on average and edges are up to 20 long: most shapes meet a few others.
constexpr double kSpacing = 8, kReach = 12;

Vec3 offset(Random& random) {
  return on_grid(Vec3{random.between(-kReach, kReach), random.between(-kReach, kReach),
                      random.between(-kReach, kReach)});
}

Object triangle(const Vec3& p, Random& random) {
  Object object;
  object.vertices = {p, p + offset(random), p + offset(random)};
  object.faces = {{{0, 1, 2}, {}}};
  return object;
}

Object parallelogram(const Vec3& p, Random& random) {
  const Vec3 a = offset(random), b = offset(random);
  Object object;
  object.vertices = {p, p + a, p + a + b, p + b};
  object.faces = {{{0, 1, 2, 3}, {}}};
  return object;
}

Object tetrahedron(const Vec3& p, Random& random) {
  Object object;
  do {
    const Vec3 points[] = {p, p + offset(random), p + offset(random), p + offset(random)};
    object = hull(points);
  } while (object.faces.empty());
  return object;
}

}  // namespace

void generate_soup(Environment& environment, std::uint32_t objects, Random& random) {
  const double side = kSpacing * root_up(objects, 3);
  for (std::uint32_t i = 0; i < objects; ++i) {
    const Vec3 p = on_grid(Vec3{random.unit() * side, random.unit() * side, random.unit() * side});
    const std::uint32_t shape = random.below(3);
    Object& object = environment.objects.emplace_back(shape == 0   ? triangle(p, random)
                                                      : shape == 1 ? parallelogram(p, random)
                                                                   : tetrahedron(p, random));
    object.name = (shape == 0   ? "triangle "
                   : shape == 1 ? "parallelogram "
                                : "tetrahedron ") +
                  std::to_string(i + 1);
  }
}

}  // namespace cigsim
