// SPDX-License-Identifier: MIT
// The random points on which Levine 1975 (ch. VII) measured his hull and his sphere: eight
// distributions, 25 to 3200 points, 500 cases each.
//
// Levine names no seed and no generator of uniform numbers; here a case is fixed by its
// distribution, its size, its number and a seed. The normal numbers come from his formulas (two
// from two uniform ones) through the C library's logarithm, sine and cosine, so they may differ in
// the last bit between libraries.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "models/numeric/vec3.hpp"

namespace cigsim {

/// Levine's distributions, in the order of his table. "Cube" and "sphere" are normal with standard
/// deviation 1, cut off at 1, 2 or 4: by each coordinate, or by the distance from the origin.
enum class PointDistribution {
  kCube1,
  kCube2,
  kCube4,
  kPolyhedron,  ///< uniform in 0 < x < 2, 0 < y < 1, 0 < z < 1
  kSphere1,
  kSphere2,
  kSphere4,
  kEllipse,  ///< uniform in x²/4 + y² + z² <= 1
};

inline constexpr std::array<PointDistribution, 8> kPointDistributions{
    PointDistribution::kCube1,      PointDistribution::kCube2,   PointDistribution::kCube4,
    PointDistribution::kPolyhedron, PointDistribution::kSphere1, PointDistribution::kSphere2,
    PointDistribution::kSphere4,    PointDistribution::kEllipse};

/// Levine's cases for each distribution and number of points.
inline constexpr std::uint32_t kPointSetCases = 500;

/// "cube-1", "cube-2", "cube-4", "polyhedron", "sphere-1", "sphere-2", "sphere-4", "ellipse".
std::string_view name_of(PointDistribution distribution);

/// The numbers of points that Levine ran, ascending: to 3200 for the cubes, 1600 for the polyhedron
/// and the ellipse, 800 for the spheres.
std::span<const std::uint32_t> published_sizes(PointDistribution distribution);

/// True when the closed region of the distribution holds `point`.
bool inside(PointDistribution distribution, const Vec3& point);

/// `count` points of one case. The same arguments always give the same points.
std::vector<Vec3> random_points(PointDistribution distribution, std::size_t count,
                                std::uint64_t seed, std::uint32_t case_number = 0);

}  // namespace cigsim
