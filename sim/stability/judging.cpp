// SPDX-License-Identifier: MIT
#include "sim/stability/judging.hpp"

#include <algorithm>
#include <cmath>

#include "models/machine/scale.hpp"
#include "sim/stability/posing.hpp"

namespace cigsim::stability {
namespace {

// Rows of the view matrix in words: what view_words() multiplies the rotation by.
struct RowScale {
  double u, v, w;
};
RowScale row_scale(const ViewTransform& view) {
  const double a = view.focal / (view.raster.width / 2.0);
  const double b = view.focal / (view.raster.height / 2.0);
  const double s = 1 / std::max({1.0, a, b});
  return {s, s * a, s * b};
}

double sum(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// How far a row's product with a corner's difference is off, in coordinate units of the machine.
double row_error(const Vec3& row, double factor, const Vec3& d, double scale, double half_bit) {
  return sum(row) * factor + half_bit * (sum(d) * scale + 3) + 0.5;
}

double largest_error(const Drawing& drawing, std::uint32_t triangle, const Sight& sight,
                     const std::vector<bool>& shared) {
  double most = 0;
  for (const Drawing::Line& edge : drawing.edges) {
    if (edge.triangle != triangle) continue;
    for (int line = edge.first_line; line < edge.end_line; ++line) {
      if (!shared[static_cast<std::size_t>(line)]) continue;
      const Exact column = edge.x + edge.slope * (line - edge.first_line);
      most = std::max(most, sight.distance_from_border(line, column, edge.left));
    }
  }
  return most;
}

// How far an edge is off at least that puts elements [first, end) on its wrong side: the way from a
// sample in their middle to the nearest border.
double error_of_run(const Sight& sight, int line, int first, int end) {
  return first < end ? sight.distance_from_all(line, (first + end - 1) / 2) : 0;
}

// Of a line's elements that one of the two covers and the other does not.
double error_of_cover(const Sight& sight, int line, const Drawing::Cover& right,
                      const Drawing::Cover& got) {
  if (right.first == right.end) return error_of_run(sight, line, got.first, got.end);
  if (got.first == got.end) return error_of_run(sight, line, right.first, right.end);
  const auto [first, begun] = std::minmax(right.first, got.first);
  const auto [ended, end] = std::minmax(right.end, got.end);
  return std::max(error_of_run(sight, line, first, std::min(begun, ended)),
                  error_of_run(sight, line, std::max(ended, begun), end));
}

}  // namespace

std::optional<double> picture_bound_in_words(const Triangle& triangle, const ViewTransform& view,
                                             const Format& format) {
  const WordFormats& formats = format.machine.formats;
  const Database database = database_of({&triangle, 1}, true);
  const double scale =
      std::ldexp(1, coordinate_scale(database, formats, largest_coordinate(view.eye)));
  const double half_bit = std::ldexp(1, -formats.direction_fraction - 1);
  const double quotient = std::ldexp(1, -formats.quotient_fraction);
  const double raster_bit = std::ldexp(1, -formats.raster_fraction);
  const RowScale rows = row_scale(view);
  double corner_error = 0;
  for (const Vec3& corner : triangle) {
    const Vec3 d = corner - view.eye;
    const double u = dot(view.rotation.row[0], d) * rows.u * scale;
    const double u_error = row_error(view.rotation.row[0], rows.u, d, scale, half_bit);
    const double side_error = std::max(row_error(view.rotation.row[1], rows.v, d, scale, half_bit),
                                       row_error(view.rotation.row[2], rows.w, d, scale, half_bit));
    if (!(u > format.machine.hither + u_error) || !(u > 2 * u_error)) return std::nullopt;
    const double ratio = (side_error + u_error) / (u - u_error) + quotient;
    const double across = view.raster.width / 2.0 * ratio + raster_bit / 2;
    const double down = view.raster.height / 2.0 * ratio + raster_bit / 2;
    corner_error = std::max(corner_error, std::hypot(across, down));
  }
  const double length_on_raster = std::hypot(view.raster.width, view.raster.height);
  const double stepping = raster_bit / 2 * (view.raster.height + 3);
  // What the corners' own rounding moves an edge by within its extent, half a line beyond its top.
  return corner_error + stepping + quotient * length_on_raster;
}

std::optional<double> picture_bound(const Triangle& triangle, const Sight& sight,
                                    const ViewTransform& view, const Format& format) {
  switch (format.arithmetic) {
    case Arithmetic::kDouble:
      return kDoubleClaim;
    case Arithmetic::kCertified:
    case Arithmetic::kExact:
      return 0;
    case Arithmetic::kMachine:
      if (sight.whole()) return picture_bound_in_words(triangle, view, format);
      break;
    case Arithmetic::kFloat:
      break;
  }
  return std::nullopt;
}

Outcome judge_cover(const Drawing& drawing, std::uint32_t triangle, const Sight& sight,
                    const Raster& raster, std::optional<double> bound) {
  bool right = true;
  double error = 0;
  std::vector<bool> shared(static_cast<std::size_t>(raster.height), false);
  for (int line = 0; line < raster.height; ++line) {
    const std::optional<Reach> reach = sight.reach(line);
    const Drawing::Cover cover = drawing.cover(triangle, line);
    shared[static_cast<std::size_t>(line)] = reach.has_value();
    Drawing::Cover must;
    if (reach && reach->first < reach->end) must = {reach->first, reach->end};
    if (must.first == cover.first && must.end == cover.end) continue;
    right = false;
    error = std::max(error, error_of_cover(sight, line, must, cover));
  }
  if (drawing.doubtful) return {Verdict::kDoubtful, {}, {}};
  error = std::max(error, largest_error(drawing, triangle, sight, shared));
  return {right ? Verdict::kRight : Verdict::kWrong, error, bound};
}

}  // namespace cigsim::stability
