// SPDX-License-Identifier: MIT
#include "sim/stability/sight.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim::stability {
namespace {

const Exact kHalf(0.5);

ExactVec normal_of(const PlaneDefinition& d) {
  return cross(convert<Exact>(d.u1) - convert<Exact>(d.u0),
               convert<Exact>(d.v1) - convert<Exact>(d.v0));
}

}  // namespace

int exact_side(const PlaneDefinition& plane, const Vec3& point) {
  return sgn(dot(normal_of(plane), convert<Exact>(point) - convert<Exact>(plane.p)));
}

double distance_from(const PlaneDefinition& plane, const Vec3& point) {
  const ExactVec n = normal_of(plane);
  const Exact square = dot(n, n);
  if (sgn(square) == 0) return 0;
  const Exact value = dot(n, convert<Exact>(point) - convert<Exact>(plane.p));
  return std::sqrt(Exact(value * value / square).get_d());
}

ExactVec in_view(const ViewTransform& view, const Vec3& point) {
  return convert<Exact>(view.rotation) * (convert<Exact>(point) - convert<Exact>(view.eye));
}

Exact exact_row(const ViewTransform& view, const ExactVec& p) {
  return Exact(view.raster.height * kHalf - Exact(view.focal) * p.z / p.x);
}

Sight::Sight(const Triangle& triangle, const ViewTransform& view) : view_(view) {
  const ExactVec corner[3] = {in_view(view, triangle[0]), in_view(view, triangle[1]),
                              in_view(view, triangle[2])};
  for (std::size_t i = 0; i < 3; ++i) normals_[i] = cross(corner[i], corner[(i + 1) % 3]);
  // The viewpoint system is left-handed: seen from the front the product is positive.
  facing_ = sgn(dot(normals_[0], corner[2]));
  if (facing_ < 0)
    for (ExactVec& n : normals_) n = {Exact(-n.x), Exact(-n.y), Exact(-n.z)};
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactVec& n = normals_[i];
    largest_[i] = std::max(Exact(abs(n.y)), Exact(abs(n.z)));
    if (sgn(largest_[i]) != 0)
      slant_[i] = std::hypot(Exact(n.y / largest_[i]).get_d(), Exact(n.z / largest_[i]).get_d());
  }
  const Exact focal(view.focal), right = view.raster.width * kHalf, up = view.raster.height * kHalf;
  whole_ = std::all_of(corner, corner + 3, [&](const ExactVec& p) {
    return sgn(p.x) > 0 && focal * abs(p.y) < right * p.x && focal * abs(p.z) < up * p.x;
  });
  if (!whole_) return;
  for (std::size_t i = 0; i < 3; ++i) rows_[i] = exact_row(view, corner[i]);
  const auto [top, bottom] = std::minmax_element(rows_.begin(), rows_.end());
  first_line_ = ceil_clamped(Exact(*top - kHalf), 0, view.raster.height);
  end_line_ = ceil_clamped(Exact(*bottom - kHalf), 0, view.raster.height);
}

// A ray through column c of row r runs along (focal, c − width/2, height/2 − r).
Sight::Side Sight::at_line(const ExactVec& n, int line) const {
  const Exact below = view_.raster.height * kHalf - (line + kHalf);
  return {Exact(n.x * Exact(view_.focal) - n.y * (view_.raster.width * kHalf) + n.z * below), n.y};
}

std::optional<Reach> Sight::reach(int line) const {
  if (facing_ == 0) return std::nullopt;
  Reach reach;
  reach.low = 0;
  reach.high = view_.raster.width;
  for (const ExactVec& n : normals_) {
    const Side side = at_line(n, line);
    if (sgn(side.b) == 0) {
      // A level border at the sample's height counts as a little above it.
      if (sgn(side.a) < 0 || (sgn(side.a) == 0 && sgn(n.z) > 0)) return std::nullopt;
      continue;
    }
    const Exact at = -side.a / side.b;
    if (sgn(side.b) > 0)
      reach.low = std::max(reach.low, at);
    else
      reach.high = std::min(reach.high, at);
  }
  if (reach.low > reach.high) return std::nullopt;
  reach.low -= kHalf;
  reach.high -= kHalf;
  reach.first = ceil_clamped(reach.low, 0, view_.raster.width);
  reach.end = ceil_clamped(reach.high, 0, view_.raster.width);
  return reach;
}

// The side's level over its slope across the border; of rationals, as either may underflow.
double Sight::distance(std::size_t i, const Side& side, const Exact& at) const {
  const Exact level = (side.a + side.b * at) / largest_[i];
  return std::abs(level.get_d()) / slant_[i];
}

double Sight::distance_from_border(int line, const Exact& column, bool left) const {
  const Exact at = column + kHalf;
  // The raster's own border.
  double least = std::abs(left ? at.get_d() : at.get_d() - view_.raster.width);
  for (std::size_t i = 0; i < 3; ++i) {
    const Side side = at_line(normals_[i], line);
    if (sgn(side.b) * (left ? 1 : -1) <= 0) continue;
    least = std::min(least, distance(i, side, at));
  }
  return least;
}

double Sight::distance_from_all(int line, int element) const {
  const Exact at = element + kHalf;
  double least = std::min({element + 0.5, view_.raster.width - element - 0.5, line + 0.5,
                           view_.raster.height - line - 0.5});
  for (std::size_t i = 0; i < 3; ++i)
    if (sgn(largest_[i]) != 0) least = std::min(least, distance(i, at_line(normals_[i], line), at));
  return least;
}

}  // namespace cigsim::stability
