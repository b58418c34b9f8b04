// SPDX-License-Identifier: MIT
#include "tests/support/viewpoints.hpp"

#include <algorithm>
#include <cmath>

#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"

namespace cigsim::test {
namespace {

struct Extent {
  Vec3 centre;
  double size;
};

Extent extent(const Object& object) {
  Vec3 sum;
  for (const Vec3& v : object.vertices) sum = sum + v;
  const Vec3 centre = sum * (1.0 / static_cast<double>(object.vertices.size()));
  double size = 0;
  for (const Vec3& v : object.vertices)
    size = std::max(size, std::sqrt(dot(v - centre, v - centre)));
  return {centre, size};
}

}  // namespace

Viewpoint plain_viewpoint(const Environment& environment, Random& random) {
  const Extent e = extent(environment.objects[random.below(environment.objects.size())]);
  const Vec3 direction = random_direction(random);
  Viewpoint viewpoint;
  double distance = e.size;
  switch (random.below(3)) {
    case 0:
      distance *= random.between(1, 4);
      viewpoint.fov = random.between(20, 120);
      break;
    case 1:
      distance *= random.between(10, 1000);
      viewpoint.fov = random.between(1, 10);
      break;
    default:
      distance *= random.between(0.01, 0.5);
      viewpoint.fov = random.between(1, 170);
  }
  viewpoint.eye = look_at(e.centre + direction * distance, e.centre);
  viewpoint.eye.heading += random.between(-10, 10);
  if (random.below(2)) viewpoint.eye.roll = random.between(-180, 180);
  return viewpoint;
}

Viewpoint random_viewpoint(const Environment& environment, Random& random) {
  const Object& object = environment.objects[random.below(environment.objects.size())];
  const std::vector<std::uint32_t>& loop = object.faces[random.below(object.faces.size())].vertices;
  const auto corner = [&](std::size_t i) { return object.vertices[loop[i % loop.size()]]; };
  Viewpoint viewpoint;
  Vec3 eye, towards = extent(environment.objects[random.below(environment.objects.size())]).centre;
  switch (random.below(8)) {
    case 0:  // in the plane of a face: exact where coordinates are short
      eye = corner(0) + (corner(1) - corner(0)) * (random.below(33) / 8.0 - 2) +
            (corner(2) - corner(0)) * (random.below(33) / 8.0 - 2);
      break;
    case 1:
      eye = corner(0);
      break;
    case 2:
      eye = (corner(0) + corner(1)) * 0.5;
      break;
    case 3:
      eye = extent(object).centre;
      break;
    case 4:  // level with a vertex, along an axis
      viewpoint.eye.position =
          corner(0) + Vec3{random.below(65) / 4.0 - 8, random.below(65) / 4.0 - 8, 0};
      viewpoint.eye.heading = 90 * random.below(4);
      viewpoint.fov = 90;
      return viewpoint;
    default:
      return plain_viewpoint(environment, random);
  }
  if (eye == towards) towards = eye + random_direction(random);
  viewpoint.fov = random.below(4) == 0 ? random.between(1, 170) : random.between(20, 120);
  viewpoint.eye = look_at(eye, towards);
  viewpoint.eye.heading += random.between(-10, 10);
  if (random.below(2)) viewpoint.eye.roll = random.between(-180, 180);
  return viewpoint;
}

Raster random_raster(Random& random, int largest) {
  const auto side = [&] { return 1 + static_cast<int>(random.below(largest)); };
  switch (random.below(12)) {
    case 0:
      return {1, 1};
    case 1:
      return {1, side()};
    case 2:
      return {side(), 1};
    default:
      return {largest / 2 + side() / 2, largest / 2 + side() / 2};
  }
}

}  // namespace cigsim::test
