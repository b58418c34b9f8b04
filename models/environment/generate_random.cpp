// SPDX-License-Identifier: MIT
// Disjoint by construction: every solid lies in a sphere inside its own cell of a lattice.
#include <cmath>

#include "models/environment/generators.hpp"
#include "models/environment/shapes.hpp"

namespace cigsim {
namespace {

constexpr double kCell = 1024;

/// From about 0.5 to 480: every octave as likely as any other.
double radius(Random& random) {
  return std::ldexp(random.between(240, 480), -int(random.below(10)));
}

Vec3 direction(Random& random) {
  Vec3 d;
  double norm;
  do {
    d = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    norm = dot(d, d);
  } while (norm > 1 || norm < 0.01);
  return d * (1 / std::sqrt(norm));
}

/// Column `axis` of a rotation, with the given length.
Vec3 turned_axis(const Mat3& m, int axis, double length) {
  Vec3 unit;
  (axis == 0 ? unit.x : axis == 1 ? unit.y : unit.z) = length;
  return on_grid(m * unit);
}

Object turned_box(const Vec3& centre, double r, Random& random) {
  const Mat3 m = random_rotation(random);
  // At most 0.57 r a half side: the corner stays within 0.99 r.
  const auto half = [&] { return r * random.between(0.15, 0.57); };
  const Vec3 a = turned_axis(m, 0, half()), b = turned_axis(m, 1, half());
  return parallelepiped(centre, a, b, turned_axis(m, 2, half()));
}

/// A prism on a polygon with small whole coordinates in a turned plane, so that it is planar.
Object turned_prism(const Vec3& centre, double r, Random& random) {
  static const std::vector<std::vector<std::pair<int, int>>> kPolygons = {
      {{16, 0}, {-8, 14}, {-8, -14}},
      {{16, 0}, {5, 15}, {-13, 9}, {-13, -9}, {5, -15}},
      {{16, 0}, {8, 14}, {-8, 14}, {-16, 0}, {-8, -14}, {8, -14}},
      {{15, 6}, {6, 15}, {-6, 15}, {-15, 6}, {-15, -6}, {-6, -15}, {6, -15}, {15, -6}}};
  const Mat3 m = random_rotation(random);
  const double width = r * random.between(0.3, 0.7);
  const Vec3 a = turned_axis(m, 0, width), b = turned_axis(m, 1, width);
  const Vec3 up = turned_axis(m, 2, r * random.between(0.2, 0.65));
  std::vector<Vec3> base;
  for (const auto& [x, y] : kPolygons[random.below(kPolygons.size())])
    base.push_back(centre - up + a * (x / 16.0) + b * (y / 16.0));
  return prism(base, up + up);
}

/// The hull of points on a turned ellipsoid; four points make a tetrahedron.
Object turned_hull(const Vec3& centre, double r, std::uint32_t points, Random& random) {
  while (true) {
    const Mat3 m = random_rotation(random);
    const Vec3 axes{0.95 * r, r * random.between(0.3, 0.95), r * random.between(0.3, 0.95)};
    std::vector<Vec3> on_ellipsoid;
    for (std::uint32_t i = 0; i < points; ++i) {
      const Vec3 d = direction(random);
      on_ellipsoid.push_back(centre + on_grid(m * Vec3{d.x * axes.x, d.y * axes.y, d.z * axes.z}));
    }
    Object object = hull(on_ellipsoid);
    if (!object.faces.empty()) return object;
  }
}

Object solid(const Vec3& centre, double r, Random& random) {
  switch (random.below(4)) {
    case 0:
      return turned_box(centre, r, random);
    case 1:
      return turned_prism(centre, r, random);
    case 2:
      return turned_hull(centre, r, 4, random);
    default:
      return turned_hull(centre, r, 6 + random.below(5), random);
  }
}

}  // namespace

void generate_random(Environment& environment, std::uint32_t objects, Random& random) {
  const std::uint32_t m = root_up(objects, 3);
  for (std::uint32_t i = 0; i < objects; ++i) {
    const double r = radius(random);
    const double play = kCell / 2 - 1 - r;
    const Vec3 cell{double(i % m), double(i / m % m), double(i / m / m)};
    const Vec3 off{random.between(-play, play), random.between(-play, play),
                   random.between(-play, play)};
    Object& object =
        environment.objects.emplace_back(solid(on_grid(cell * kCell + off), r, random));
    object.name = "solid " + std::to_string(i + 1);
  }
}

}  // namespace cigsim
