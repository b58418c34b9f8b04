// SPDX-License-Identifier: MIT
// How far each element is from the nearest of some marked ones: exact, in time linear in the
// elements. A. Meijster, J. Roerdink and W. Hesselink, "A general algorithm for computing distance
// transforms in linear time", 2000.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cigsim {

/// Where nothing is marked.
inline constexpr std::uint32_t kNoDistance = 0xffffffff;

/// The square of the Euclidean distance between the centres of each element and of the nearest
/// marked one, in elements, row by row; kNoDistance throughout without a mark. `marked` has
/// width x height values, each side 1 to 16384.
std::vector<std::uint32_t> squared_distances(std::span<const std::uint8_t> marked, int width,
                                             int height);

}  // namespace cigsim
