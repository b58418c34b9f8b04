// SPDX-License-Identifier: MIT
// Sandor's observer (1979, sec. 2.2 and 3): environment axes, an observer's frame with z' ahead,
// and a view plane at distance d. The project's own viewpoint system has u ahead, v right and w up:
// his (x', y', z') are (v, w, u).
#pragma once

#include <array>

#include "models/numeric/number.hpp"

namespace cigsim::survey {

/// Turns about the observer's axes, in degrees, in this order: Y, X, Z.
struct ObserverAngles {
  double theta1 = 0;  ///< about Y
  double theta2 = 0;  ///< about X
  double theta3 = 0;  ///< about Z
};

/// The three turns as one matrix: p' = matrix * (p - observer).
Mat3 observer_rotation(const ObserverAngles& angles);

/// Equation 3.1.2: the homogeneous matrix that translates and turns, entry by entry. The scan shows
/// the third factor of its last translation term as cos(theta3); that of the product is
/// cos(theta2).
std::array<std::array<double, 4>, 4> observer_matrix(const Vec3& observer,
                                                     const ObserverAngles& angles);

/// Equation 3.2.1: perspective onto the plane z' = d, with the depth (z' - d) d / z'. Lines stay
/// straight and planes flat, and of two points ahead the one with the larger z' has the larger
/// depth. z' must not be 0; what is behind the view plane must be clipped before.
template <class N>
Vec3T<N> perspective(const Vec3T<N>& p, const N& d) {
  const N scale(d / p.z);
  return {N(p.x * scale), N(p.y * scale), N((p.z - d) * scale)};
}

/// The pyramid of vision: the screen is |x| <= half_width, |y| <= half_height in the view plane
/// z' = d > 0, and nothing before that plane is seen.
template <class N>
struct ViewBox {
  N d{}, half_width{}, half_height{};
};

}  // namespace cigsim::survey
