// SPDX-License-Identifier: MIT
// The plane just ahead of the eyepoint to which a machine of words clips first
// (docs/machine/geometry_processor.md, GP3). Doubles and exact numbers have none.
#include <algorithm>
#include <cmath>

#include "models/machine/scale.hpp"
#include "sim/stability/catalogue.hpp"
#include "sim/stability/drawing.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"

namespace cigsim::stability {
namespace {

// An instance: points[0] is a corner of the environment, twice as far out as the
// eyepoint; spheres[0].radius says how many units
// of the machine's coordinate word ahead of the hither plane the triangle is. The triangle itself
// depends on the machine.
Instance pose(const Material& material, const Extremes& extremes, Random& random) {
  const Triangle base = triangle_of(material, extremes, random);
  const Place place(extremes, random);
  const Vec3 eye = place(eyepoint_for(material, base, extremes, random));
  Instance instance;
  const double reach = 2 * largest_coordinate(eye) + place.scale() * size_of(base);
  instance.points.push_back({reach, reach, reach});
  instance.view = view_towards(eye, place(centre_of(base)), extremes, random);
  const double size = std::ldexp(0.25, static_cast<int>(random.below(12)));
  const double way = random.below(2) == 0 ? -1 : 1;
  Sphere ahead;
  ahead.radius = way * (extremes.ulps ? std::min(*extremes.ulps, 128.0) / 16 : size);
  instance.spheres.push_back(ahead);
  return instance;
}

// The smallest u of the machine, environment units: view_words() multiplies u by this and 2^scale.
Exact row_factor(const ViewTransform& view) {
  const Exact a = Exact(view.focal) * 2 / view.raster.width;
  const Exact b = Exact(view.focal) * 2 / view.raster.height;
  return Exact(1 / std::max({Exact(1), a, b}));
}

Exact power(int exponent) {
  Exact out(1);
  if (exponent >= 0)
    mpq_mul_2exp(out.get_mpq_t(), out.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else
    mpq_div_2exp(out.get_mpq_t(), out.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return out;
}

// Across the line of sight, wide enough to cover the middle of the raster, `depth` ahead.
Triangle facing_triangle(const ViewTransform& view, double depth) {
  const double right = depth * (view.raster.width / 2.0) / view.focal * 0.7;
  const double up = depth * (view.raster.height / 2.0) / view.focal * 0.7;
  const Mat3& r = view.rotation;
  const auto at = [&](double v, double w) {
    return view.eye + r.row[0] * depth + r.row[1] * v + r.row[2] * w;
  };
  return {at(-right, -up), at(right, -up), at(0, up)};
}

Outcome judge_in(const Instance& instance, const Format& format) {
  const ViewTransform& view = instance.view;
  const WordFormats& formats = format.machine.formats;
  const Vec3& far = instance.points[0];
  const Triangle reach{far, far, far};
  const int scale =
      coordinate_scale(database_of({&reach, 1}, true), formats, largest_coordinate(view.eye));
  const Exact unit = power(-scale) / row_factor(view);  // of u, environment units
  const Exact hither = unit * format.machine.hither;
  const double depth = Exact(hither + unit * Exact(instance.spheres[0].radius)).get_d();
  const Triangle faces[2] = {facing_triangle(view, depth), reach};
  // With words so few that the hither plane lies beyond the environment nothing can be asked.
  for (const Vec3& corner : faces[0])
    if (largest_coordinate(corner) > largest_coordinate(far)) return {};
  int ahead = 0;
  double border = 0;
  for (const Vec3& corner : faces[0]) {
    const Exact beyond = (in_view(view, corner).x - hither) / unit;
    ahead += sgn(beyond) >= 0;
    border = std::max(border, std::abs(beyond.get_d()));
  }
  // A triangle that hither cuts is no yes or no.
  if (ahead != 0 && ahead != 3) return {};
  const Drawing drawing = draw(faces, true, view, format);
  bool drawn = false;
  for (const Drawing::Face& face : drawing.faces) drawn |= face.triangle == 0;
  if (drawing.doubtful) return {Verdict::kDoubtful, {}, {}};
  // Half a unit for the corner and the eyepoint in each coordinate, and half a unit for u; the
  // matrix is off by half a unit of its word times the differences, each below the depth.
  const Vec3& row = view.rotation.row[0];
  const double sum =
      (std::abs(row.x) + std::abs(row.y) + std::abs(row.z)) * row_factor(view).get_d();
  double differences = 0;
  for (const Vec3& corner : faces[0]) {
    const Vec3 d = corner - view.eye;
    differences = std::max(differences, std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
  }
  const double half_bit = std::ldexp(1, -formats.direction_fraction - 1);
  return answer(drawn == (ahead == 3), border,
                sum + 0.5 + half_bit * (std::ldexp(differences, scale) + 3));
}

std::vector<Outcome> judge(const Instance& instance, std::span<const Format> formats) {
  return in_each(formats, [&](const Format& format) {
    return format.arithmetic == Arithmetic::kMachine ? judge_in(instance, format) : Outcome{};
  });
}

}  // namespace

Decision hither_decision() {
  return {"hither",
          "Whether a face lies ahead of the hither plane; words only. `near` counts sixteenths of "
          "their unit, 128 at most",
          "units of the coordinate word",
          {Axis::kScale, Axis::kOffset, Axis::kNear, Axis::kFov, Axis::kDistance, Axis::kMixed},
          false,
          pose,
          judge};
}

}  // namespace cigsim::stability
