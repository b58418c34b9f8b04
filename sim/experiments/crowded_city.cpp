// SPDX-License-Identifier: MIT
#include "sim/experiments/crowded_city.hpp"

#include <algorithm>
#include <cmath>

#include "models/environment/generate.hpp"
#include "models/environment/placement.hpp"

namespace cigsim {
namespace {

/// The pyramid of vision of a square picture.
class Pyramid {
 public:
  explicit Pyramid(const Viewpoint& viewpoint)
      : eye_(viewpoint.eye.position),
        axes_(body_axes(viewpoint.eye)),
        sine_(sin_degrees(viewpoint.fov / 2)),
        cosine_(cos_degrees(viewpoint.fov / 2)) {}

  /// True when all vertices lie beyond one side. Two solids that a plane parts do not touch, so
  /// what is outside keeps clear of what is inside.
  bool excludes(const Object& object) const {
    const Vec3 left = axes_.row[1] * cosine_, up = axes_.row[2] * cosine_,
               ahead = axes_.row[0] * sine_;
    const Vec3 outward[] = {left - ahead, Vec3{} - left - ahead, up - ahead, Vec3{} - up - ahead};
    return std::any_of(std::begin(outward), std::end(outward), [&](const Vec3& normal) {
      return std::all_of(object.vertices.begin(), object.vertices.end(),
                         [&](const Vec3& v) { return dot(normal, v - eye_) > 0; });
    });
  }

 private:
  Vec3 eye_;
  Mat3 axes_;
  double sine_, cosine_;
};

}  // namespace

CrowdedCity make_crowded_city(std::uint32_t visible, std::uint32_t objects, std::uint64_t seed) {
  CrowdedCity city{generate_environment("city", {visible, seed}), {}};
  city.viewpoint = {city.environment.view->eye, city.environment.view->fov};
  if (objects <= visible) return city;
  const Pyramid pyramid(city.viewpoint);
  // The pyramid takes less than a third of the ground.
  Environment around =
      generate_environment("city", {static_cast<std::uint32_t>(1.5 * objects), seed + 1});
  const Vec3 corner = around.ground.front().vertices[0],
             opposite = around.ground.front().vertices[2];
  const Vec3 middle = (corner + opposite) * 0.5, eye = city.viewpoint.eye.position;
  const Vec3 shift{std::floor(eye.x - middle.x), std::floor(eye.y - middle.y), 0};
  for (Object& object : around.objects) {
    if (city.environment.objects.size() == objects) break;
    for (Vec3& v : object.vertices) v = v + shift;
    if (pyramid.excludes(object)) city.environment.objects.push_back(std::move(object));
  }
  return city;
}

}  // namespace cigsim
