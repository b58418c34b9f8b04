// SPDX-License-Identifier: MIT
// What preparation decides once, whatever the frames' format: convex loops, hulls, the smallest
// sphere.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "models/database/hull/hull.hpp"
#include "models/database/polygon.hpp"
#include "models/database/sphere/sphere.hpp"
#include "sim/stability/catalogue.hpp"
#include "sim/stability/exact_sphere.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"

namespace cigsim::stability {
namespace {

std::vector<Outcome> alike(const Outcome& outcome, std::span<const Format> formats) {
  return std::vector<Outcome>(formats.size(), outcome);
}

// What the points span, by looking for points off the line and the plane of others.
int spanned(const std::vector<Vec3>& points) {
  const std::size_t n = points.size();
  std::size_t b = 1;
  while (b < n && points[b] == points[0]) ++b;
  if (b == n) return 0;
  std::size_t c = b + 1;
  const auto normal = [&](std::size_t at) {
    return cross(convert<Exact>(points[b]) - convert<Exact>(points[0]),
                 convert<Exact>(points[at]) - convert<Exact>(points[0]));
  };
  while (c < n && normal(c) == ExactVec{}) ++c;
  if (c >= n) return 1;
  const PlaneDefinition plane = plane_of(Triangle{points[0], points[b], points[c]});
  return std::any_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return exact_side(plane, p) != 0; })
             ? 3
             : 2;
}

// ---- convexity

// A loop of a few corners round the triangle's circle, with one corner on the straight line of its
// neighbours, or `ulps` off it; else it may turn in.
Instance pose_loop(const Material& material, const Extremes& extremes, Random& random) {
  const Triangle base = triangle_of(material, extremes, random);
  const Place place(extremes, random);
  const std::uint32_t corners = 4 + random.below(4);
  const Vec3 middle = centre_of(base), x = base[1] - base[0], y = base[2] - base[0];
  Instance instance;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * (i + random.between(0, 0.5)) / corners;
    instance.points.push_back(place(middle + x * std::cos(turn) + y * std::sin(turn)));
  }
  const std::uint32_t i = random.below(corners);
  Vec3& corner = instance.points[i];
  const Vec3& before = instance.points[(i + corners - 1) % corners];
  const Vec3& after = instance.points[(i + 1) % corners];
  if (extremes.ulps) {
    // The plane through the neighbours, upright on the loop's plane.
    const Vec3 out = cross(x, y);
    const ExactVec normal =
        cross(convert<Exact>(after) - convert<Exact>(before), convert<Exact>(out));
    corner = near_border(before + (after - before) * random.between(0.2, 0.8),
                         {normal, convert<Exact>(before)}, *extremes.ulps, random);
  } else if (random.below(2) == 0) {
    corner = corner + (place(middle) - corner) * random.between(0, 1);
  }
  return instance;
}

// The loop as preparation flattens it, in rationals.
using Flat = std::vector<std::array<Exact, 2>>;

Exact turn(const Flat& p, std::size_t a, std::size_t b, std::size_t c) {
  return Exact((p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) -
               (p[b][1] - p[a][1]) * (p[c][0] - p[a][0]));
}

// Convex and run round once: no corner is right of any side, and the corners follow each other in
// the order of the angle at which the middle of them sees them.
bool exactly_convex(const Flat& p) {
  const std::size_t n = p.size();
  std::array<Exact, 2> middle{Exact(0), Exact(0)};
  for (const auto& corner : p)
    for (std::size_t k = 0; k < 2; ++k) middle[k] += corner[k] / static_cast<unsigned long>(n);
  Flat with_middle = p;
  with_middle.push_back(middle);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k)
      if (sgn(turn(p, i, (i + 1) % n, k)) < 0) return false;
    // Seen from the middle every side runs anticlockwise: no side runs back over another.
    if (sgn(turn(with_middle, n, i, (i + 1) % n)) <= 0) return false;
  }
  return true;
}

std::vector<Outcome> judge_loop(const Instance& instance, std::span<const Format> formats) {
  Loop loop(instance.points.size());
  std::iota(loop.begin(), loop.end(), 0u);
  const auto flat = FlatLoop::make(instance.points, loop);
  if (!flat) return alike(answer(spanned(instance.points) < 2, 0, 0), formats);
  Flat exact;
  for (const std::uint32_t v : loop) exact.push_back({Exact(flat->at(v).x), Exact(flat->at(v).y)});
  for (std::size_t i = 0; i < exact.size(); ++i)  // rounded to one place: no loop any more
    for (std::size_t k = 0; k < i; ++k)
      if (exact[i] == exact[k]) return alike({}, formats);
  // However the loop is turned to be looked at.
  const bool convex = exactly_convex(exact) || exactly_convex({exact.rbegin(), exact.rend()});
  return alike(answer(is_convex(*flat, loop) == convex, 0, 0), formats);
}

// ---- hull

// Points about a body, some of them near the plane of three others.
std::vector<Vec3> pose_points(const Material& material, const Extremes& extremes, Random& random) {
  const Place place(extremes, random);
  std::vector<Vec3> points;
  if (!material.bodies.empty()) {
    points = material.bodies[random.below(material.bodies.size())];
    if (points.size() > 40) points.resize(40);
    for (Vec3& p : points) p = place(p);
  } else {
    const std::uint32_t count = 6 + random.below(8);
    for (std::uint32_t i = 0; i < count; ++i)
      points.push_back(place(Vec3{random.between(-0.5, 0.5), random.between(-0.5, 0.5),
                                  extremes.aspect * random.between(-0.5, 0.5)}));
  }
  if (!extremes.ulps) return points;
  const Border border = border_of(plane_of(Triangle{points[0], points[1], points[2]}));
  for (std::size_t i = 3; i < points.size(); i += 2)
    points[i] = near_border(points[i], border, *extremes.ulps, random);
  return points;
}

Instance pose_hull(const Material& material, const Extremes& extremes, Random& random) {
  Instance instance;
  instance.points = pose_points(material, extremes, random);
  return instance;
}

bool encloses(const std::vector<Vec3>& points, const HullTriangle& t) {
  const PlaneDefinition plane = plane_of(Triangle{points[t[0]], points[t[1]], points[t[2]]});
  const ExactVec n = border_of(plane).normal;
  if (sgn(n.x) == 0 && sgn(n.y) == 0 && sgn(n.z) == 0) return false;
  return std::none_of(points.begin(), points.end(),
                      [&](const Vec3& p) { return exact_side(plane, p) > 0; });
}

bool closed(const std::vector<HullTriangle>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const HullTriangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!edges.emplace(t[i], t[(i + 1) % 3]).second) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.contains({e.second, e.first});
  });
}

// A closed surface of triangles, all points on or behind each of them: the hull.
std::vector<Outcome> judge_hull(const Instance& instance, std::span<const Format> formats) {
  const std::vector<Vec3>& points = instance.points;
  const Hull hull = convex_hull(points);
  bool right = hull.dimension == spanned(points);
  if (hull.dimension == 3) {
    right &= closed(hull.triangles) && hull.triangles.size() == 2 * hull.vertices.size() - 4;
    for (const HullTriangle& t : hull.triangles) right &= encloses(points, t);
  }
  return alike(answer(right, 0, 0), formats);
}

// ---- smallest sphere

// Five points and more, of which some lie on one sphere but for rounding or the ulps.
Instance pose_sphere(const Material& material, const Extremes& extremes, Random& random) {
  Instance instance;
  Extremes free = extremes;
  free.ulps.reset();
  instance.points = pose_points(material, free, random);
  if (!extremes.ulps) return instance;
  const Vec3 centre = (instance.points[0] + instance.points[1]) * 0.5;
  const double radius = length(instance.points[0] - centre);
  for (std::size_t i = 2; i < instance.points.size(); i += 2) {
    Vec3& p = instance.points[i];
    p = centre + unit(p - centre) * radius;
    const double most = largest_coordinate(p), ulp = std::nextafter(most, HUGE_VAL) - most;
    p.x += (random.below(2) == 0 ? -1 : 1) * *extremes.ulps * ulp;
  }
  return instance;
}

std::vector<Outcome> judge_sphere(const Instance& instance, std::span<const Format> formats) {
  const BoundingSphere sphere = minimum_sphere(instance.points);
  const SphereProof proof = prove(sphere, instance.points);
  return alike({proof.right ? Verdict::kRight : Verdict::kWrong, proof.excess, proof.bound},
               formats);
}

}  // namespace

Decision convexity_decision() {
  return {"convexity", "Whether a loop is convex",
          "",          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kMixed},
          true,        pose_loop,
          judge_loop};
}

Decision hull_decision() {
  return {"hull",    "Whether the convex hull is one: closed, no point outside",
          "",        {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kMixed},
          true,      pose_hull,
          judge_hull};
}

Decision sphere_decision() {
  return {"sphere",
          "Whether the smallest sphere rests on the right points and holds all of them",
          "environment units",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kMixed},
          true,
          pose_sphere,
          judge_sphere};
}

}  // namespace cigsim::stability
