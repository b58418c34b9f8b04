// SPDX-License-Identifier: MIT
// Whether a hull is the hull of its points, proved with rationals and nothing of the code tested.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "models/database/hull/hull.hpp"

namespace cigsim::test {

/// The sign of det(b − a, c − a, d − a) in rationals.
int rational_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// A solid hull: the triangles are a closed surface with 2 · vertices − 4 of them, no point lies
/// outside any, and every vertex is an extreme point.
testing::AssertionResult is_hull(std::span<const Vec3> points, const Hull& hull);

/// The hull's vertices as coordinates, sorted.
std::vector<Vec3> corner_points(std::span<const Vec3> points, const Hull& hull);

/// Both have the same dimension and the same vertices.
testing::AssertionResult same_hull(std::span<const Vec3> points, const Hull& a, const Hull& b);

}  // namespace cigsim::test
