// SPDX-License-Identifier: MIT
// Visibility priority from a BSP tree (Fuchs, Kedem, Naylor 1980, "Image generation phase").
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/bsp/tree.hpp"

namespace cigsim {

/// The polygons (items of the tree's set) in the order in which a painter draws them: at each node
/// the side where the eye is not, the node's polygons, the side where it is. Of coplanar polygons
/// the first of the scene comes last, so that it wins where they overlap. An eye on a plane counts
/// as on its positive side; it sees the node's polygons edge-on, and neither side hides the other.
/// Decided exactly. Any depth.
std::vector<std::uint32_t> back_to_front(const BspTree& tree, const Vec3& eye);

/// The reverse of that: the nearest first.
std::vector<std::uint32_t> front_to_back(const BspTree& tree, const Vec3& eye);

/// Priority numbers in the order of BspTree::members, from 1; where two polygons cover one point of
/// the picture the one with the higher number is seen.
std::vector<std::uint32_t> visibility_priorities(const BspTree& tree, const Vec3& eye);

}  // namespace cigsim
