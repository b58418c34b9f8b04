// SPDX-License-Identifier: MIT
// Whether half-spaces have a common point, by eliminating one coordinate after the other (Fourier
// and Motzkin) in rational numbers: nothing in common with what it is to check.
#pragma once

#include <vector>

#include "models/numeric/number.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim::test {

/// a x + b y + c z >= d, or > d when `open`.
struct HalfSpace {
  Exact a[3], d;
  bool open = false;
};

/// The closed TRUE side of a plane, or its open FALSE side.
HalfSpace half_space(const Plane& plane, bool true_side);

bool have_common_point(std::vector<HalfSpace> spaces);

}  // namespace cigsim::test
