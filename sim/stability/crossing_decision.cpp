// SPDX-License-Identifier: MIT
// The order of crossings on a line, where faces share an edge or nearly do.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/stability/catalogue.hpp"
#include "sim/stability/judging.hpp"
#include "sim/stability/posing.hpp"

namespace cigsim::stability {
namespace {

constexpr std::size_t kFaces = 3;

Triangle triangle(const Instance& instance, std::size_t i) {
  return {instance.points[3 * i], instance.points[3 * i + 1], instance.points[3 * i + 2]};
}

// Two faces on either side of an edge, and a third that has an edge from the middle of the shared
// one, turned away from it by the angle; all in one plane but for rounding.
Instance pose(const Material& material, const Extremes& extremes, Random& random) {
  Material things = material;
  things.eyepoints.clear();  // all must be seen whole
  Extremes whole = extremes;
  whole.distance =
      std::max(extremes.distance, 1.8 / std::tan(extremes.fov * std::numbers::pi / 360));
  if (extremes.fov > 90) whole.distance = std::max(whole.distance, 2.4);
  const Triangle a = triangle_of(material, extremes, random);
  const Triangle b{a[1], a[0], a[0] + a[1] - a[2]};
  const Vec3 along = a[1] - a[0], across = a[2] - a[0];
  const double turn = extremes.angle.value_or(random.between(0.1, 0.5));
  const Triangle c{a[0] + along * 0.5, a[1] + across * turn, a[2]};
  const Place place(whole, random);
  const Vec3 eye = place(eyepoint_for(things, a, whole, random));
  Instance instance;
  for (const Triangle& t : {a, b, c})
    for (const Vec3& corner : t) instance.points.push_back(place(corner));
  instance.view = view_towards(eye, place((a[0] + a[1]) * 0.5), whole, random);
  if (!extremes.ulps) return instance;
  // The third face's edge is the shared one, but for the ulps by which its end is off.
  const ExactVec normal = cross(convert<Exact>(instance.points[0]) - convert<Exact>(eye),
                                convert<Exact>(instance.points[1]) - convert<Exact>(eye));
  instance.points[7] =
      near_border(instance.points[1], {normal, convert<Exact>(eye)}, *extremes.ulps, random);
  return instance;
}

// A crossing as the machine's rule orders it: by element, right before left, then by face.
struct Place {
  int element = 0;
  bool left = false;
  std::uint32_t triangle = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};

using Order = std::vector<std::pair<std::uint32_t, bool>>;

Order true_order(std::span<const Sight> sights, int line) {
  std::vector<Place> places;
  for (std::uint32_t i = 0; i < sights.size(); ++i) {
    const auto reach = sights[i].reach(line);
    if (line < sights[i].first_line() || line >= sights[i].end_line() || !reach) continue;
    places.push_back({reach->first, true, i});
    places.push_back({reach->end, false, i});
  }
  std::sort(places.begin(), places.end());
  Order order;
  for (const Place& p : places) order.emplace_back(p.triangle, p.left);
  return order;
}

Order drawn_order(const Drawing& drawing, int line) {
  Order order;
  const auto first = drawing.crossings.first[static_cast<std::size_t>(line)];
  const auto end = drawing.crossings.first[static_cast<std::size_t>(line) + 1];
  for (std::uint32_t c = first; c < end; ++c) {
    const Crossing& crossing = drawing.crossings.crossings[c];
    order.emplace_back(drawing.faces[crossing.face].triangle, crossing.left);
  }
  return order;
}

std::vector<Outcome> judge(const Instance& instance, std::span<const Format> formats) {
  std::vector<Triangle> faces;
  std::vector<Sight> sights;
  for (std::size_t i = 0; i < kFaces; ++i) {
    faces.push_back(triangle(instance, i));
    sights.emplace_back(faces.back(), instance.view);
    // Lines of a clipped face are another decision's.
    if (!sights.back().whole() || sights.back().facing() == 0)
      return std::vector<Outcome>(formats.size());
  }
  const int height = instance.view.raster.height;
  std::vector<Order> truth;
  for (int line = 0; line < height; ++line) truth.push_back(true_order(sights, line));
  return in_each(formats, [&](const Format& format) {
    const Drawing drawing = draw(faces, true, instance.view, format);
    if (drawing.doubtful) return Outcome{Verdict::kDoubtful, {}, {}};
    bool right = true;
    for (int line = 0; line < height; ++line)
      right &= drawn_order(drawing, line) == truth[static_cast<std::size_t>(line)];
    return answer(right);
  });
}

}  // namespace

Decision crossing_order_decision() {
  return {"crossing-order",
          "The order of a line's crossings where two faces share an edge and a third nearly does",
          "",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kParallel, Axis::kSliver, Axis::kEdgeOn,
           Axis::kFov, Axis::kDistance, Axis::kMixed},
          false,
          pose,
          judge};
}

}  // namespace cigsim::stability
