// SPDX-License-Identifier: MIT
#include "models/database/sphere/sphere_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "models/numeric/dispatch.hpp"

namespace cigsim {
namespace {

struct Magnitudes {
  double largest = 0;
  double smallest = std::numeric_limits<double>::infinity();  // that is not 0
  double spoilt = 0;                                          // NaN when a coordinate is not finite
};

CIGSIM_DISPATCH Magnitudes magnitudes_of(const double* values, std::size_t count) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  constexpr std::size_t kLanes = 8;
  double large[kLanes] = {}, small[kLanes], spoilt[kLanes] = {};
  std::fill_n(small, kLanes, kNone);
  const auto take = [&](std::size_t lane, double value) {
    const double magnitude = std::abs(value);
    large[lane] = magnitude > large[lane] ? magnitude : large[lane];
    const double nonzero = magnitude > 0 ? magnitude : kNone;
    small[lane] = nonzero < small[lane] ? nonzero : small[lane];
    spoilt[lane] += value * 0;
  };
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k) take(k, values[i + k]);
  for (; i < count; ++i) take(0, values[i]);
  Magnitudes all;
  for (std::size_t k = 0; k < kLanes; ++k) {
    all.largest = std::max(all.largest, large[k]);
    all.smallest = std::min(all.smallest, small[k]);
    all.spoilt += spoilt[k];
  }
  return all;
}

Whole whole_number(double value, int shift) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  Whole out(std::ldexp(mantissa, 53));
  const int up = exponent - 53 + shift;
  if (up >= 0)
    out <<= static_cast<unsigned>(up);
  else
    out >>= static_cast<unsigned>(-up);  // only zeros: denormal doubles have fewer bits
  return out;
}

}  // namespace

SpherePoints::SpherePoints(std::span<const Vec3> points) : points_(points), work_(points) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  if (points.size() > (std::size_t{1} << 31)) throw std::invalid_argument("more than 2^31 points");
  const Magnitudes m = magnitudes_of(points.empty() ? nullptr : &points[0].x, 3 * points.size());
  if (std::isnan(m.spoilt)) throw std::invalid_argument("a coordinate is not a finite number");
  largest_ = m.largest;
  if (m.largest == 0) return;
  int low = 0;
  std::frexp(m.smallest, &low);
  whole_shift_ = std::min(53 - low, 1074);
  if (m.largest >= 0x1p-100 && m.largest <= 0x1p100) return;
  std::frexp(m.largest, &exponent_);
  // 2^-exponent may be beyond the doubles; its halves are not.
  const double half = std::ldexp(1.0, -(exponent_ / 2)),
               rest = std::ldexp(1.0, -(exponent_ - exponent_ / 2));
  scaled_.reserve(points.size());
  for (const Vec3& p : points)
    scaled_.push_back({p.x * half * rest, p.y * half * rest, p.z * half * rest});
  work_ = scaled_;
  largest_ = m.largest * half * rest;
  scale_error_ = 0x1p-1073;
}

WholeVec SpherePoints::whole(std::uint32_t i) const {
  const Vec3& p = points_[i];
  return {whole_number(p.x, whole_shift_), whole_number(p.y, whole_shift_),
          whole_number(p.z, whole_shift_)};
}

}  // namespace cigsim
