// SPDX-License-Identifier: MIT
// Whether a sphere is the smallest one round its points, proved with rationals and nothing of the
// code tested.
#pragma once

#include <gtest/gtest.h>

#include <span>

#include "models/database/sphere/sphere.hpp"
#include "models/numeric/number.hpp"

namespace cigsim::test {

/// Proves it by the conditions of Kuhn and Tucker: the centre of the sphere through the support, in
/// the space that the support spans, is a mean of the support with weights that are not negative,
/// and no point lies outside. Proves too that the sphere as rounded holds all points, and is wider
/// by few ulps only.
testing::AssertionResult is_smallest_sphere(std::span<const Vec3> points,
                                            const BoundingSphere& sphere);

}  // namespace cigsim::test
