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

// 0 when none is above it.
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

SphereScan::Farthest SphereScan::scan_block(const ScannedSphere& sphere, std::size_t i) {
  double distance[kBlock];
  const auto points = block(i);
  squared_distances(points.data(), points.size(), sphere.x.high, sphere.y.high, sphere.z.high,
                    distance);
  most_[i] = largest_of(distance, points.size());
  const auto place = std::find(distance, distance + points.size(), most_[i]) - distance;
  return {static_cast<std::uint32_t>(i * kBlock + static_cast<std::size_t>(place)), most_[i]};
}

SphereScan::Farthest SphereScan::farthest(const ScannedSphere& sphere) {
  Farthest best{0, -1};
  centre_ = {sphere.x.high, sphere.y.high, sphere.z.high};
  for (std::size_t i = 0; i < most_.size(); ++i) {
    const Farthest far = scan_block(sphere, i);
    if (far.squared_distance > best.squared_distance) best = far;
  }
  return best;
}

std::vector<std::uint32_t> SphereScan::outside(const ScannedSphere& sphere) {
  const double limit = sphere.squared_radius.high + band(sphere);
  std::vector<std::uint32_t> out;
  centre_ = {sphere.x.high, sphere.y.high, sphere.z.high};
  for (std::size_t i = 0; i < most_.size(); ++i) {
    const Farthest far = scan_block(sphere, i);
    if (far.squared_distance > limit) out.push_back(far.point);
  }
  return out;
}

SphereScan::Closer SphereScan::closer_look(const ScannedSphere& sphere) const {
  double excess[kBlock];
  const double bound = bound_of(sphere);
  // A point outside now was at most `moved` nearer to the centre of the pass.
  const Vec3 shift = Vec3{sphere.x.high, sphere.y.high, sphere.z.high} - centre_;
  const double moved = (std::abs(shift.x) + std::abs(shift.y) + std::abs(shift.z)) * 1.001;
  const double least = sphere.squared_radius.high -
                       2.001 * moved * std::sqrt(sphere.squared_radius.high) - band(sphere);
  Closer out;
  for (std::size_t i = 0; i < most_.size(); ++i) {
    if (most_[i] < least) continue;
    const auto points = block(i);
    excesses(points.data(), points.size(), sphere, excess);
    const double most = largest_of(excess, points.size());
    const auto place = [&](const double* e) {
      return static_cast<std::uint32_t>(i * kBlock + static_cast<std::size_t>(e - excess));
    };
    if (most > bound) out.outside.push_back(place(std::find(excess, excess + points.size(), most)));
    if (most > bound && most > out.excess) {
      out.excess = most;
      out.farthest = out.outside.back();
    }
    for (const double* e = excess; e != excess + points.size(); ++e)
      if (std::abs(*e) <= bound) out.doubtful.push_back(place(e));
  }
  return out;
}

}  // namespace cigsim
