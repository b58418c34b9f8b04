// SPDX-License-Identifier: MIT
// Whether the eyepoint sees a face from its front (Sandor 1979, sec. 5.1; Stump 1986, ch. II).
//
// What a machine thinks of a face shows in what it draws. Drawn are the face and its back, each to
// be seen from its front only, and the face again as one with two sides: of the first two exactly
// the one that looks at the eyepoint must come out, and the third must have its left edges on the
// left.
//
// A face may be missing for other reasons, though: it is cut away, or lies between two lines after
// rounding. It is the decision's fault where the machine says that it took the face for no front,
// or where the same corners come out with a plane that no format is in doubt of, square to the line
// of sight. Else the decision came to nothing, and is not counted.
#include <algorithm>
#include <cmath>

#include "models/machine/scale.hpp"
#include "models/numeric/unit_normal.hpp"
#include "sim/stability/catalogue.hpp"
#include "sim/stability/drawing.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"

namespace cigsim::stability {
namespace {

Instance pose(const Material& material, const Extremes& extremes, Random& random) {
  Instance instance = pose_face(material, extremes, random);
  if (!extremes.ulps) return instance;
  const Triangle t = corners(instance);
  const Vec3 eye = near_border(instance.view.eye, border_of(plane_of(t)), *extremes.ulps, random);
  instance.view = view_towards(eye, point_of(t, random), extremes, random);
  return instance;
}

// What exact arithmetic says.
struct Truth {
  int facing = 0;
  Triangle shown{};            ///< the corners as they run anticlockwise for the eyepoint
  bool drawn = false;          ///< it reaches over the sample height of some line
  std::vector<bool> elements;  ///< by line: it covers some
};

Truth truth_of(const Triangle& t, const ViewTransform& view) {
  Truth truth;
  truth.facing = exact_side(plane_of(t), view.eye);
  truth.shown = truth.facing < 0 ? Triangle{t[0], t[2], t[1]} : t;
  const Sight sight(t, view);
  for (int line = 0; line < view.raster.height; ++line) {
    const std::optional<Reach> reach = sight.reach(line);
    truth.drawn |= reach && reach->low < reach->high;
    truth.elements.push_back(reach && reach->first < reach->end);
  }
  return truth;
}

// The triangle with a plane through its first corner, square to the line from there to the
// eyepoint.
Drawing draw_with_plain_plane(const Triangle& t, const ViewTransform& view, const Format& format) {
  Database database = database_of({&t, 1}, false);
  const Vec3 d = unit(view.eye - t[0]);
  const bool upright = std::abs(d.z) > 0.5;
  const Vec3 across = unit(cross(d, upright ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
  database.systems[0].set.planes[0] = make_plane({t[0], {}, across, {}, cross(d, across)});
  return draw(database, view, format);
}

// How far, in environment units, rounding to a machine's words may move an eyepoint against a
// face's plane. Derived: half a unit of the coordinate word for the corner and half for the
// eyepoint, times the normal's elements; half a unit of the direction word times their differences.
double bound_in_words(const Triangle& t, const ViewTransform& view, const Format& format) {
  const WordFormats& formats = format.machine.formats;
  const int scale =
      coordinate_scale(database_of({&t, 1}, false), formats, largest_coordinate(view.eye));
  const auto sum = [](const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
  const Vec3 n = unit_normal(make_plane(plane_of(t)));
  const double half_bit = std::ldexp(1, -formats.direction_fraction - 1) + 0x1p-50;
  return std::ldexp(sum(n) + 3 * half_bit, -scale) + half_bit * sum(view.eye - t[0]);
}

std::optional<double> bound_for(const Triangle& t, const ViewTransform& view,
                                const Format& format) {
  if (format.arithmetic == Arithmetic::kFloat) return std::nullopt;
  if (format.arithmetic != Arithmetic::kMachine) return 0;
  return bound_in_words(t, view, format);
}

bool shows(const Drawing& drawing, int line) {
  const Drawing::Cover cover = drawing.cover(0, line);
  return cover.first < cover.end;
}

Outcome judge_in(const Triangle& t, const Truth& truth, const ViewTransform& view,
                 const Format& format) {
  const Triangle both[2] = {t, {t[0], t[2], t[1]}};
  const Drawing one_sided = draw(both, false, view, format);
  if (one_sided.doubtful) return {Verdict::kDoubtful, {}, {}};
  const double border = distance_from(plane_of(t), view.eye);
  const std::optional<double> bound = bound_for(t, view, format);
  const bool turned_away = std::any_of(
      one_sided.faces.begin(), one_sided.faces.end(),
      [&](const Drawing::Face& face) { return truth.facing != (face.triangle == 0 ? 1 : -1); });
  if (turned_away) return answer(false, border, bound);
  if (truth.facing == 0) return answer(true, border, bound);
  if (!truth.drawn) return {};
  const std::size_t front = truth.facing > 0 ? 0 : 1;
  const bool taken_for_none = !one_sided.shown.empty() && !one_sided.shown[front];
  if (taken_for_none) return answer(false, border, bound);
  const Drawing plain = draw_with_plain_plane(truth.shown, view, format);
  if (plain.doubtful || plain.faces.empty()) return {};
  bool right = !one_sided.faces.empty();
  const Drawing two_sided = draw({&t, 1}, true, view, format);
  for (int line = 0; line < view.raster.height; ++line)
    if (truth.elements[static_cast<std::size_t>(line)] && shows(plain, line))
      right &= shows(two_sided, line);
  return answer(right, border, bound);
}

std::vector<Outcome> judge(const Instance& instance, std::span<const Format> formats) {
  const Triangle t = corners(instance);
  const Truth truth = truth_of(t, instance.view);
  return in_each(formats,
                 [&](const Format& format) { return judge_in(t, truth, instance.view, format); });
}

}  // namespace

Decision facing_decision() {
  return {"facing",
          "Whether the eyepoint sees a face from its front, from its back, or edge on",
          "environment units",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kSliver, Axis::kEdgeOn, Axis::kFov,
           Axis::kDistance, Axis::kMixed},
          false,
          pose,
          judge};
}

}  // namespace cigsim::stability
