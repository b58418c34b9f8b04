// SPDX-License-Identifier: MIT
#include "sim/stability/posing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/database/sphere/rounding.hpp"
#include "models/frame_calculator/functional.hpp"

namespace cigsim::stability {
namespace {

double sign(Random& random) { return random.below(2) == 0 ? -1 : 1; }

Vec3 random_point(Random& random) {
  return {random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
}

// The third corner moved towards the line of the first two.
Triangle squeezed(Triangle t, double aspect) {
  if (aspect == 1) return t;
  const Vec3 along = unit(t[1] - t[0]);
  const Vec3 foot = t[0] + along * dot(t[2] - t[0], along);
  t[2] = foot + (t[2] - foot) * aspect;
  return t;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

Place::Place(const Extremes& extremes, Random& random)
    : scale_(extremes.scale), shift_(random_direction(random) * extremes.offset) {}

Triangle Place::operator()(const Triangle& t) const {
  return {(*this)(t[0]), (*this)(t[1]), (*this)(t[2])};
}

PlaneDefinition Place::operator()(const PlaneDefinition& plane) const {
  PlaneDefinition placed = plane;
  placed.p = (*this)(plane.p);
  if (plane.u0 == Vec3{} && plane.v0 == Vec3{}) return placed;
  placed.u0 = (*this)(plane.u0);
  placed.u1 = (*this)(plane.u1);
  placed.v0 = (*this)(plane.v0);
  placed.v1 = (*this)(plane.v1);
  return placed;
}

Triangle triangle_of(const Material& material, const Extremes& extremes, Random& random) {
  if (!material.triangles.empty())
    return squeezed(material.triangles[random.below(material.triangles.size())], extremes.aspect);
  for (;;) {
    const Triangle t{random_point(random), random_point(random), random_point(random)};
    if (length(cross(t[1] - t[0], t[2] - t[0])) > 0.1) return squeezed(t, extremes.aspect);
  }
}

double size_of(const Triangle& t) {
  return std::max({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
}

Vec3 centre_of(const Triangle& t) { return (t[0] + t[1] + t[2]) * (1.0 / 3); }

PlaneDefinition plane_of(const Triangle& t) { return {t[0], t[0], t[1], t[0], t[2]}; }

PlaneDefinition plane_of(const Material& material, const Extremes& extremes, Random& random) {
  if (material.planes.empty() || extremes.aspect != 1)
    return plane_of(triangle_of(material, extremes, random));
  return material.planes[random.below(material.planes.size())];
}

Vec3 eyepoint_for(const Material& material, const Triangle& t, const Extremes& extremes,
                  Random& random) {
  const bool free = !extremes.grazing && extremes.distance == Extremes().distance;
  if (free && !material.eyepoints.empty() && random.below(2) == 0)
    return material.eyepoints[random.below(material.eyepoints.size())];
  const Vec3 along = unit(t[1] - t[0]);
  Vec3 out = cross(along, unit(t[2] - t[0]));
  if (!(length(out) > 1e-300)) out = random_direction(random);
  const Vec3 normal = unit(out), across = cross(normal, along);
  const double turn = random.between(0, 2 * std::numbers::pi);
  const double height = extremes.grazing ? *extremes.grazing : random.between(0.2, 1.5);
  const Vec3 level = along * std::cos(turn) + across * std::sin(turn);
  const Vec3 direction = level * std::cos(height) + normal * std::sin(height);
  return centre_of(t) + direction * (extremes.distance * size_of(t));
}

Vec3 point_of(const Triangle& t, Random& random) {
  double a = random.unit(), b = random.unit();
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  if (random.below(2) == 0) b = 0;
  return t[0] + (t[1] - t[0]) * a + (t[2] - t[0]) * b;
}

ViewTransform view_towards(const Vec3& eye, const Vec3& target, const Extremes& extremes,
                           Random& random) {
  const Vec3 d = unit(target - eye);
  Viewpoint viewpoint;
  viewpoint.eye.position = eye;
  viewpoint.eye.heading = degrees(std::atan2(d.x, d.y));
  viewpoint.eye.pitch = degrees(std::atan2(d.z, std::hypot(d.x, d.y)));
  viewpoint.eye.roll = random.between(-180, 180);
  viewpoint.fov = extremes.fov;
  return frame_calculator::view_transform(viewpoint, extremes.raster);
}

Instance pose_face(const Material& material, const Extremes& extremes, Random& random) {
  const Triangle base = triangle_of(material, extremes, random);
  const Place place(extremes, random);
  Instance instance;
  const Vec3 eye = place(eyepoint_for(material, base, extremes, random));
  const Vec3 target = place(point_of(base, random));
  add_corners(instance, place(base));
  instance.view = view_towards(eye, target, extremes, random);
  return instance;
}

void add_corners(Instance& instance, const Triangle& t) {
  instance.points.insert(instance.points.end(), t.begin(), t.end());
}

Triangle corners(const Instance& instance) {
  return {instance.points[0], instance.points[1], instance.points[2]};
}

Border border_of(const PlaneDefinition& plane) {
  return {cross(convert<Exact>(plane.u1) - convert<Exact>(plane.u0),
                convert<Exact>(plane.v1) - convert<Exact>(plane.v0)),
          convert<Exact>(plane.p)};
}

Vec3 near_border(const Vec3& point, const Border& border, double ulps, Random& random) {
  const Exact n[3] = {border.normal.x, border.normal.y, border.normal.z};
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(n[i]) > abs(n[axis])) axis = i;
  const double side = sign(random);
  if (sgn(n[axis]) == 0) return point;
  const ExactVec d = convert<Exact>(point) - border.through;
  const Exact at = (axis == 0   ? Exact(point.x)
                    : axis == 1 ? Exact(point.y)
                                : Exact(point.z)) -
                   dot(border.normal, d) / n[axis];
  Vec3 moved = point;
  double& c = axis == 0 ? moved.x : axis == 1 ? moved.y : moved.z;
  c = nearest_double(at);
  const double most = largest_coordinate(moved);
  const double ulp = std::nextafter(most, std::numeric_limits<double>::infinity()) - most;
  c += side * ulps * ulp;
  return moved;
}

}  // namespace cigsim::stability
