// SPDX-License-Identifier: MIT
// Side of a separation plane, and the list of a group whose planes are near each other.
#include <cmath>
#include <numbers>

#include "sim/stability/catalogue.hpp"
#include "sim/stability/listing.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"

namespace cigsim::stability {
namespace {

// A point about the plane's own: its distance from it is drawn, or what the grazing angle says.
Vec3 eyepoint_about(const Material& material, const PlaneDefinition& plane,
                    const Extremes& extremes, Random& random) {
  const Vec3 along = unit(plane.u1 - plane.u0), other = plane.v1 - plane.v0;
  const Triangle t{plane.p, plane.p + along,
                   plane.p + unit(other - along * dot(other, along)) * extremes.aspect};
  return eyepoint_for(material, t, extremes, random);
}

Instance pose_side(const Material& material, const Extremes& extremes, Random& random) {
  const PlaneDefinition plane = plane_of(material, extremes, random);
  const Place place(extremes, random);
  const Vec3 eye = place(eyepoint_about(material, plane, extremes, random));
  Instance instance;
  instance.planes.push_back(place(plane));
  if (random.below(2) == 0) {  // seen from the other side
    PlaneDefinition& p = instance.planes[0];
    std::swap(p.u0, p.v0);
    std::swap(p.u1, p.v1);
  }
  Vec3 at = eye;
  if (extremes.ulps) at = near_border(eye, border_of(instance.planes[0]), *extremes.ulps, random);
  instance.view = view_towards(at, instance.planes[0].p, extremes, random);
  return instance;
}

// Doubles and exact numbers claim never to be wrong, words not beyond their rounding, float
// nothing.
std::optional<double> plane_bound(const PlaneDefinition& plane, const ViewTransform& view,
                                  const Format& format) {
  if (format.arithmetic == Arithmetic::kFloat) return std::nullopt;
  if (format.arithmetic != Arithmetic::kMachine) return 0;
  return plane_bound_in_words(plane, view, format);
}

std::vector<Outcome> judge_side(const Instance& instance, std::span<const Format> formats) {
  const PlaneDefinition& plane = instance.planes[0];
  const Table table{2, {plane}, {{0, 1}}};
  const Listing truth = exact_list(table, instance.view.eye);
  const double border = distance_from(plane, instance.view.eye);
  return in_each(formats, [&](const Format& format) {
    return answer(list(table, instance.view, format) == truth, border,
                  plane_bound(plane, instance.view, format));
  });
}

// Three members one behind the other, with a plane for each pair; the angle tilts the planes
// against each other.
Instance pose_group(const Material& material, const Extremes& extremes, Random& random) {
  const Place place(extremes, random);
  Instance instance;
  const Triangle base = triangle_of(material, extremes, random);
  const double apart = extremes.angle ? 0 : 0.25 * size_of(base);
  const double tilt = extremes.angle.value_or(random.between(0, 0.5)) * size_of(base);
  const Vec3 normal = unit(cross(base[1] - base[0], base[2] - base[0]));
  for (int i = 0; i < 3; ++i) {
    Triangle t = base;
    for (Vec3& corner : t) corner = corner + normal * (apart * i + tilt * random.between(-1, 1));
    instance.planes.push_back(plane_of(place(t)));
  }
  Vec3 at = eyepoint_for(material, base, extremes, random);
  // Between planes that are nearly parallel, where their order tells.
  if (extremes.angle)
    at = at - normal * dot(at - base[0], normal) + normal * (tilt * random.between(-1, 1));
  at = place(at);
  if (extremes.ulps)
    at = near_border(at, border_of(instance.planes[random.below(3)]), *extremes.ulps, random);
  instance.view = view_towards(at, place(centre_of(base)), extremes, random);
  return instance;
}

// From the back to the front a, b, c: planes a|b, a|c, b|c.
Table group_table(const Instance& instance) {
  return {3, instance.planes, {{1, 0}, {2, 0}, {2, 1}}};
}

std::vector<Outcome> judge_group(const Instance& instance, std::span<const Format> formats) {
  const Table table = group_table(instance);
  const Listing truth = exact_list(table, instance.view.eye);
  double border = distance_from(table.planes[0], instance.view.eye);
  for (const PlaneDefinition& plane : table.planes)
    border = std::min(border, distance_from(plane, instance.view.eye));
  return in_each(formats, [&](const Format& format) {
    std::optional<double> bound = 0;
    for (const PlaneDefinition& plane : table.planes) {
      const auto claimed = plane_bound(plane, instance.view, format);
      bound = bound && claimed ? std::optional(std::max(*bound, *claimed)) : std::nullopt;
    }
    return answer(list(table, instance.view, format) == truth, border, bound);
  });
}

}  // namespace

Decision side_decision() {
  return {"side",
          "On which side of a separation plane the eyepoint is",
          "environment units",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kEdgeOn, Axis::kDistance,
           Axis::kMixed},
          false,
          pose_side,
          judge_side};
}

Decision listability_decision() {
  return {"listability",
          "The list of three members whose planes are near each other, and whether counts are "
          "unique",
          "environment units",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kParallel, Axis::kSliver, Axis::kEdgeOn,
           Axis::kDistance, Axis::kMixed},
          false,
          pose_group,
          judge_group};
}

}  // namespace cigsim::stability
