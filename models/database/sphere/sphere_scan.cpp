// SPDX-License-Identifier: MIT
#include "models/database/sphere/sphere_scan.hpp"

#include <algorithm>
#include <cmath>

#include "models/numeric/dispatch.hpp"
#include "models/numeric/expansion.hpp"

namespace cigsim {
namespace {

// Below this nothing is decided: products may have lost bits to underflow.
constexpr double kUnderflow = 0x1p-900;

CIGSIM_DISPATCH void squared_distances(const Vec3* points, std::size_t count, double cx, double cy,
                                       double cz, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const double x = points[i].x - cx, y = points[i].y - cy, z = points[i].z - cz;
    out[i] = x * x + y * y + z * z;
  }
}

CIGSIM_DISPATCH double largest_of(const double* values, std::size_t count) {
  constexpr std::size_t kLanes = 8;
  double most[kLanes] = {};
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k)
      most[k] = values[i + k] > most[k] ? values[i + k] : most[k];
  for (; i < count; ++i) most[0] = values[i] > most[0] ? values[i] : most[0];
  return *std::max_element(most, most + kLanes);
}

// (p − c)² as high + low: the difference s + e with e small, its square's leading part exact.
inline void square_of_difference(double p, const TwoDoubles& c, double& high, double& low) {
  double s, e;
  two_sum(p, -c.high, s, e);
  e -= c.low;
  double product_low;
  two_product(s, s, high, product_low);
  low = product_low + e * (2 * s + e);
}

// |p − c|² − r² of each point, off by at most bound_of(sphere) near the sphere.
CIGSIM_DISPATCH void excesses(const Vec3* points, std::size_t count, const ScannedSphere& given,
                              double* out) {
  const ScannedSphere sphere = given;
  for (std::size_t i = 0; i < count; ++i) {
    double xh, xl, yh, yl, zh, zl, sum, a, b, c;
    square_of_difference(points[i].x, sphere.x, xh, xl);
    square_of_difference(points[i].y, sphere.y, yh, yl);
    square_of_difference(points[i].z, sphere.z, zh, zl);
    two_sum(xh, yh, sum, a);
    two_sum(sum, zh, sum, b);
    two_sum(sum, -sphere.squared_radius.high, sum, c);
    out[i] = sum + (a + b + c + xl + yl + zl - sphere.squared_radius.low);
  }
}

// The low parts are at most 2^-53 (8 r² + 4 r C) with C the largest coordinate; ten roundings of
// them, and the precision of centre and radius, stay below 2^-98 (r² + r C).
double bound_of(const ScannedSphere& sphere) {
  const double squared = sphere.squared_radius.high;
  return 0x1p-96 * (squared + std::sqrt(squared) * sphere.largest) + kUnderflow;
}

}  // namespace

SphereScan::SphereScan(std::span<const Vec3> points)
    : points_(points), most_((points.size() + kBlock - 1) / kBlock) {}

std::span<const Vec3> SphereScan::block(std::size_t i) const {
  return points_.subspan(i * kBlock, std::min(kBlock, points_.size() - i * kBlock));
}

// A squared distance d² is off by less than 2^-50 d C + 2^-50 d²; the last term covers spheres that
// are small against the rounding of their centre.
double SphereScan::band(const ScannedSphere& sphere) {
  const double squared = sphere.squared_radius.high, c = sphere.largest;
  return 0x1p-46 * squared + 0x1p-48 * std::sqrt(squared) * c + 0x1p-98 * c * c + kUnderflow;
}

SphereScan::Farthest SphereScan::farthest(const ScannedSphere& sphere) {
  double distance[kBlock];
  Farthest best;
  double most = -1;
  for (std::size_t i = 0; i < most_.size(); ++i) {
    const auto points = block(i);
    squared_distances(points.data(), points.size(), sphere.x.high, sphere.y.high, sphere.z.high,
                      distance);
    most_[i] = largest_of(distance, points.size());
    if (most_[i] <= most) continue;
    most = most_[i];
    const auto place = std::find(distance, distance + points.size(), most) - distance;
    best = {static_cast<std::uint32_t>(i * kBlock + static_cast<std::size_t>(place)), most};
  }
  return best;
}

SphereScan::Closer SphereScan::closer_look(const ScannedSphere& sphere) const {
  double excess[kBlock];
  const double least = sphere.squared_radius.high - band(sphere), bound = bound_of(sphere);
  Closer out;
  out.excess = bound;
  for (std::size_t i = 0; i < most_.size(); ++i) {
    if (most_[i] < least) continue;
    const auto points = block(i);
    excesses(points.data(), points.size(), sphere, excess);
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (excess[k] < -bound) continue;
      const auto point = static_cast<std::uint32_t>(i * kBlock + k);
      if (excess[k] <= bound) out.doubtful.push_back(point);
      if (excess[k] <= out.excess) continue;
      out.excess = excess[k];
      out.point = point;
    }
  }
  if (out.excess == bound) out.excess = 0;
  return out;
}

}  // namespace cigsim
