// SPDX-License-Identifier: MIT
// Retrieval: a sphere may be left out only if it lies wholly outside a plane of the pyramid of
// vision (Levine 1975, ch. II), and must be where it does so beyond all rounding. The frame
// calculator computes in doubles whatever the frames' format.
#include <array>
#include <cmath>

#include "models/database/sphere/rounding.hpp"
#include "models/frame_calculator/retrieval.hpp"
#include "sim/stability/catalogue.hpp"
#include "sim/stability/posing.hpp"

namespace cigsim::stability {
namespace {

// Inward normals, without rounding: the four sides, and across the line of sight.
std::array<ExactVec, 5> inward_normals(const ViewTransform& view) {
  const Exact f(view.focal), w = Exact(view.raster.width) / 2, h = Exact(view.raster.height) / 2;
  const ExactVec sides[5] = {{w, f, 0}, {w, Exact(-f), 0}, {h, 0, f}, {h, 0, Exact(-f)}, {1, 0, 0}};
  const Mat3T<Exact> r = convert<Exact>(view.rotation);
  std::array<ExactVec, 5> normals;
  for (std::size_t i = 0; i < 5; ++i)
    normals[i] = r.row[0] * sides[i].x + r.row[1] * sides[i].y + r.row[2] * sides[i].z;
  return normals;
}

// How far the sphere reaches into the plane's inner side, over the plane's normal; negative: not.
// The sign is exact, the size a double.
struct Depth {
  int sign = 0;
  double size = 0;
};
Depth depth_inside(const Sphere& sphere, const ViewTransform& view, const ExactVec& normal) {
  const Exact value = dot(normal, convert<Exact>(sphere.centre) - convert<Exact>(view.eye));
  const Exact square = dot(normal, normal), radius(sphere.radius);
  const Exact reach = radius * radius * square;
  const double size = sphere.radius + value.get_d() / std::sqrt(square.get_d());
  if (sgn(value) >= 0) return {1, size};
  return {cmp(reach, Exact(value * value)), size};
}

Sphere sphere_of(const Material& material, const Triangle& t, const Extremes& extremes,
                 Random& random) {
  if (!material.spheres.empty()) return material.spheres[random.below(material.spheres.size())];
  return {centre_of(t), size_of(t) * extremes.aspect * random.between(0.01, 0.5)};
}

Instance pose(const Material& material, const Extremes& extremes, Random& random) {
  const Triangle base = triangle_of(material, extremes, random);
  const Place place(extremes, random);
  Sphere sphere = sphere_of(material, base, extremes, random);
  const Vec3 eye = place(eyepoint_for(material, base, extremes, random));
  const Vec3 target = place(sphere.centre + random_direction(random) * (3 * sphere.radius));
  sphere.centre = place(sphere.centre);
  sphere.radius *= place.scale();
  Instance instance;
  instance.view = view_towards(eye, target, extremes, random);
  if (extremes.ulps) {  // it touches a plane from outside, but for the ulps
    const ExactVec n = inward_normals(instance.view)[random.below(5)];
    const Exact value = dot(n, convert<Exact>(sphere.centre) - convert<Exact>(eye));
    if (sgn(value) > 0) {  // to the outer side of it
      const Exact back = -2 * value / dot(n, n);
      sphere.centre = {nearest_double(Exact(sphere.centre.x + n.x * back)),
                       nearest_double(Exact(sphere.centre.y + n.y * back)),
                       nearest_double(Exact(sphere.centre.z + n.z * back))};
    }
    const Exact outside = dot(n, convert<Exact>(sphere.centre) - convert<Exact>(eye));
    const double touch = root_nearest(Exact(outside * outside / dot(n, n)));
    const double ulp = std::nextafter(touch, HUGE_VAL) - touch;
    sphere.radius = touch + (random.below(2) == 0 ? -1 : 1) * *extremes.ulps * ulp;
    if (!(sphere.radius > 0)) sphere.radius = touch;
  }
  instance.spheres.push_back(sphere);
  return instance;
}

bool kept(const Instance& instance) {
  PriorityHierarchy hierarchy;
  hierarchy.members.push_back({false, 0, instance.spheres[0], false});
  Group group;
  group.member_count = 1;
  hierarchy.groups.push_back(group);
  frame_calculator::Choices choices(hierarchy, instance.view, 1);
  std::vector<ActiveGroup> active;
  frame_calculator::retrieve(hierarchy, instance.view, {}, true, choices, active);
  return !active.empty() && active[0].active != 0;
}

// What a sphere may lie outside by and yet be kept: four times what retrieval allows for rounding,
// and a rounding of the radius.
double margin(const Sphere& sphere, const Vec3& eye) {
  const auto sum = [](const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
  return 0x1p-1058 + 0x1p-46 * (sum(sphere.centre) + sum(eye) + sphere.radius);
}

std::vector<Outcome> judge(const Instance& instance, std::span<const Format> formats) {
  bool outside = false;
  double least = HUGE_VAL;
  for (const ExactVec& normal : inward_normals(instance.view)) {
    const Depth depth = depth_inside(instance.spheres[0], instance.view, normal);
    outside |= depth.sign < 0;
    least = std::min(least, depth.size);
  }
  const bool clearly = least < -margin(instance.spheres[0], instance.view.eye);
  const bool right = kept(instance) ? !clearly : outside;
  const Outcome outcome = answer(right, std::abs(least), 0);
  return std::vector<Outcome>(formats.size(), outcome);
}

}  // namespace

Decision retrieval_decision() {
  return {
      "retrieval",
      "A sphere that reaches into every plane of the pyramid of vision is kept, and one clearly "
      "outside of a plane is left out",
      "environment units",
      {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kFov, Axis::kDistance, Axis::kMixed},
      true,
      pose,
      judge};
}

}  // namespace cigsim::stability
