// SPDX-License-Identifier: MIT
// The geometry processor's decisions about one face: what does the pyramid of vision leave of it,
// on which lines does it begin and end, where do its edges cross lines.
#include <cmath>
#include <numbers>

#include "sim/stability/catalogue.hpp"
#include "sim/stability/judging.hpp"
#include "sim/stability/posing.hpp"

namespace cigsim::stability {
namespace {

// A triangle wholly within the pyramid: seen from so far that it fills most of it.
Instance pose_whole_face(const Material& material, Extremes extremes, Random& random) {
  const double half = std::tan(extremes.fov * std::numbers::pi / 360);
  Material without_eyes = material;
  without_eyes.eyepoints.clear();
  extremes.distance = std::max(extremes.distance, 0.9 / half);
  if (half > 1) extremes.distance = std::max(extremes.distance, 1.2);
  const Triangle base = triangle_of(material, extremes, random);
  const Place place(extremes, random);
  Instance instance;
  const Vec3 eye = place(eyepoint_for(without_eyes, base, extremes, random));
  add_corners(instance, place(base));
  instance.view = view_towards(eye, place(centre_of(base)), extremes, random);
  return instance;
}

// A plane through the eyepoint, its normal given in the viewpoint system.
Border through_eye(const ViewTransform& view, const ExactVec& normal) {
  const Mat3T<Exact> r = convert<Exact>(view.rotation);
  return {r.row[0] * normal.x + r.row[1] * normal.y + r.row[2] * normal.z,
          convert<Exact>(view.eye)};
}

// Where the sample height of a line lies.
Border line_border(const ViewTransform& view, int line) {
  const Exact above = Exact(view.raster.height) / 2 - line - Exact(0.5);
  return through_eye(view, {above, 0, Exact(-Exact(view.focal))});
}

// ---- pyramid, edge

std::vector<Outcome> judge_face(const Instance& instance, std::span<const Format> formats) {
  const Triangle t = corners(instance);
  const Sight sight(t, instance.view);
  return in_each(formats, [&](const Format& format) {
    return judge_cover(draw({&t, 1}, true, instance.view, format), 0, sight, instance.view.raster,
                       picture_bound(t, sight, instance.view, format));
  });
}

// A corner near one of the four sides, in front of the eyepoint.
Instance pose_pyramid(const Material& material, const Extremes& extremes, Random& random) {
  Instance instance = pose_face(material, extremes, random);
  if (!extremes.ulps) return instance;
  const ViewTransform& view = instance.view;
  const int side = static_cast<int>(random.below(4));
  const double half = (side < 2 ? view.raster.width : view.raster.height) / 2.0;
  const double way = side % 2 == 0 ? 1 : -1;
  const Border border = side < 2 ? through_eye(view, {Exact(half), Exact(way * view.focal), 0})
                                 : through_eye(view, {Exact(half), 0, Exact(way * view.focal)});
  Vec3& corner = instance.points[random.below(3)];
  corner = near_border(corner, border, *extremes.ulps, random);
  return instance;
}

// The first edge passes near the sample of an element: its second corner is near the plane through
// the eyepoint, the first corner and the sample's ray.
Instance pose_edge(const Material& material, const Extremes& extremes, Random& random) {
  Instance instance = pose_whole_face(material, extremes, random);
  if (!extremes.ulps) return instance;
  const ViewTransform& view = instance.view;
  const Raster& raster = view.raster;
  const Exact column(raster.width / 4 + static_cast<int>(random.below(
                                            1 + static_cast<std::uint64_t>(raster.width) / 2)));
  const Exact row(raster.height / 4 + static_cast<int>(random.below(
                                          1 + static_cast<std::uint64_t>(raster.height) / 2)));
  const ExactVec ray{Exact(view.focal), Exact(column + Exact(0.5) - Exact(raster.width) / 2),
                     Exact(Exact(raster.height) / 2 - row - Exact(0.5))};
  const ExactVec normal = cross(in_view(view, instance.points[0]), ray);
  instance.points[1] =
      near_border(instance.points[1], through_eye(view, normal), *extremes.ulps, random);
  return instance;
}

// ---- projection

Instance pose_projection(const Material& material, const Extremes& extremes, Random& random) {
  Instance instance = pose_whole_face(material, extremes, random);
  if (!extremes.ulps) return instance;
  const int height = instance.view.raster.height;
  const int line =
      height / 4 + static_cast<int>(random.below(1 + static_cast<std::uint64_t>(height) / 2));
  Vec3& corner = instance.points[random.below(3)];
  corner = near_border(corner, line_border(instance.view, line), *extremes.ulps, random);
  return instance;
}

// How near the lines that the triangle begins and ends on are to being others, in lines.
double line_border_of(const Sight& sight) {
  double least = 1;
  for (const Exact& row : sight.rows()) {
    const double sample = row.get_d() - 0.5;
    least = std::min(least, std::abs(sample - std::round(sample)));
  }
  return least;
}

std::vector<Outcome> judge_projection(const Instance& instance, std::span<const Format> formats) {
  const Triangle t = corners(instance);
  const Sight sight(t, instance.view);
  if (!sight.whole() || sight.facing() == 0) return std::vector<Outcome>(formats.size());
  const bool drawn = sight.first_line() < sight.end_line();
  const double border = line_border_of(sight);
  return in_each(formats, [&](const Format& format) {
    const Drawing drawing = draw({&t, 1}, true, instance.view, format);
    if (drawing.doubtful) return Outcome{Verdict::kDoubtful, {}, {}};
    std::optional<double> bound = picture_bound(t, sight, instance.view, format);
    if (drawing.faces.empty()) {
      // Words take it for a face that is seen edge on, which is another decision's claim.
      if (format.arithmetic == Arithmetic::kMachine) bound.reset();
      return answer(!drawn, border, bound);
    }
    return answer(drawing.faces[0].first_line == sight.first_line() &&
                      drawing.faces[0].end_line == sight.end_line(),
                  border, bound);
  });
}

}  // namespace

Decision pyramid_decision() {
  return {"pyramid",
          "What the pyramid of vision leaves of a face: the elements that it covers",
          "elements",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kEdgeOn, Axis::kFov,
           Axis::kDistance, Axis::kMixed},
          false,
          pose_pyramid,
          judge_face};
}

Decision projection_decision() {
  return {"projection",
          "On which lines the corners of a face lie",
          "lines",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kEdgeOn, Axis::kFov,
           Axis::kDistance, Axis::kMixed},
          false,
          pose_projection,
          judge_projection};
}

Decision edge_decision() {
  return {"edge",
          "At which elements the edges of a face cross its lines: start and slope",
          "elements",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kEdgeOn, Axis::kFov,
           Axis::kDistance, Axis::kMixed},
          false,
          pose_edge,
          judge_face};
}

}  // namespace cigsim::stability
