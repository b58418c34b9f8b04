// SPDX-License-Identifier: MIT
// The settings that nothing beats: V. Pareto's front of two costs.
#pragma once

#include <span>
#include <vector>

#include "models/numeric/orientation2.hpp"

namespace cigsim {

/// Which points have no other that is as good in both coordinates and better in one; less is
/// better. Equal points are on the front together. Coordinates must not be NaN.
std::vector<bool> pareto_front(std::span<const Vec2> points);

}  // namespace cigsim
