// SPDX-License-Identifier: MIT
// On which side of a separation plane the eyepoint is, in each number type (Stump 1986, ch. III:
// TRUE on the plane), and how far the eyepoint may move without a change of the answer. That
// clearance is ours.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "models/numeric/number.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim::priority_processor {

/// TRUE when the eyepoint is on the normal's side or on the plane. In double and Exact the answer
/// is exact (a filter, then rational arithmetic); float computes in float.
template <class N>
bool eye_on_true_side(const Plane& plane, const Vec3& eye) {
  if constexpr (std::is_same_v<N, float>) {
    const Vec3T<float> n = convert<float>(plane.normal), p = convert<float>(plane.exact.p);
    return dot(n, convert<float>(eye) - p) >= 0;
  } else {
    return side(plane, eye) >= 0;
  }
}

/// A lower bound on how far an eyepoint of doubles may move before the answer in float can change;
/// 0 where none can be told. With u = 2^-24 and S = sum |n| (|eye| + |p|) over the axes, the value
/// in float is within 8 u S of n·(eye - p) for the plane's rounded normal and point: one u for the
/// eye's rounding, one for the difference, one for the product, two for the sums, three to spare;
/// what is lost where numbers are subnormal is below kLost for each unit of the normal.
inline double clearance_in_float(const Plane& plane, const Vec3& eye) {
  constexpr double kError = 0x1p-21, kLost = 0x1p-140, kMost = 0x1p100;
  const Vec3T<float> n = convert<float>(plane.normal), p = convert<float>(plane.exact.p);
  const double value = dot(n, convert<float>(eye) - p);
  const double nx = std::abs(n.x), ny = std::abs(n.y), nz = std::abs(n.z);
  const double sum = nx * (std::abs(eye.x) + std::abs(p.x)) +
                     ny * (std::abs(eye.y) + std::abs(p.y)) +
                     nz * (std::abs(eye.z) + std::abs(p.z));
  // No float may overflow, here or within the clearance.
  const double largest =
      std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z), double{std::abs(p.x)},
                double{std::abs(p.y)}, double{std::abs(p.z)}, nx, ny, nz, sum});
  if (!(largest < kMost)) return 0;
  // Once for the error here, three times for that of the other eyepoint, whose sum is below 3 S.
  const double certain = std::abs(value) - 4 * kError * sum - kLost * (nx + ny + nz + 1);
  const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
  if (!(certain > 0) || !(length > 0x1p-300)) return 0;
  return std::min(certain / length * (1 - 0x1p-40), kMost);
}

/// eye_on_true_side() with a clearance: at every eyepoint of doubles nearer to this one than that
/// the answer is the same.
template <class N>
bool eye_on_true_side(const Plane& plane, const Vec3& eye, double& clearance) {
  if constexpr (std::is_same_v<N, float>) {
    clearance = clearance_in_float(plane, eye);
    return eye_on_true_side<float>(plane, eye);
  } else {
    return side(plane, eye, clearance) >= 0;
  }
}

}  // namespace cigsim::priority_processor
