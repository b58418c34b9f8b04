// SPDX-License-Identifier: MIT
#include "benchmarks/city_scene.hpp"

#include <algorithm>
#include <limits>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/placement.hpp"

namespace cigsim::benchmarks {
namespace {

constexpr int kEyepoints = 16;
constexpr double kStep = 0.25;    ///< environment units from eyepoint to eyepoint
constexpr double kMargin = 1.01;  ///< for the flight sideways

/// Half the distance by which the objects overhang a pyramid through the origin on its two sides,
/// and the shift along `axis` that makes both sides alike.
struct Fit {
  double overhang, shift;
};
Fit fit(const Environment& environment, const Vec3& ahead, const Vec3& axis, double tangent) {
  double above = -std::numeric_limits<double>::infinity(), below = above;
  for (const Object& object : environment.objects)
    for (const Vec3& p : object.vertices) {
      above = std::max(above, dot(axis, p) - tangent * dot(ahead, p));
      below = std::max(below, -dot(axis, p) - tangent * dot(ahead, p));
    }
  return {(above + below) / 2, (above - below) / 2};
}

/// The nearest eyepoint with the view's attitude from which all objects are in a square picture.
Vec3 nearest_eye(const Environment& environment, const DefaultView& view) {
  const Mat3 axes = body_axes(view.eye);
  const double tangent = sin_degrees(view.fov / 2) / cos_degrees(view.fov / 2) / kMargin;
  const Fit across = fit(environment, axes.row[0], axes.row[1], tangent);
  const Fit upright = fit(environment, axes.row[0], axes.row[2], tangent);
  const double back = std::max(across.overhang, upright.overhang) / tangent;
  return axes.row[1] * across.shift + axes.row[2] * upright.shift - axes.row[0] * back;
}

}  // namespace

CityScene make_city(bool with_ground) {
  Environment environment = generate_environment("city", {200, 1});
  if (!with_ground) environment.ground.clear();
  CityScene scene{prepare(environment), {}};
  Viewpoint viewpoint{environment.view->eye, environment.view->fov};
  const Vec3 eye = nearest_eye(environment, *environment.view);
  for (int k = 0; k < kEyepoints; ++k) {
    viewpoint.eye.position = {eye.x + kStep * (k - kEyepoints / 2), eye.y, eye.z};
    scene.path.push_back(viewpoint);
  }
  return scene;
}

}  // namespace cigsim::benchmarks
