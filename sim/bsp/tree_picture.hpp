// SPDX-License-Identifier: MIT
// A BSP tree as a drawing, in the manner of Fuchs, Kedem, Naylor 1980, figs. 7 and 8: the tree with
// its positive branches to the left, and beside it the polygons with arrows on their positive
// sides.
#pragma once

#include <string>

#include "models/database/bsp/tree.hpp"

namespace cigsim {

/// Trees of more nodes than this are drawn from the root down, level by level; "+7" stands for a
/// subtree of seven nodes.
inline constexpr std::size_t kMostNodesDrawn = 240;
/// Scenes of more parts than this are not drawn beside their tree.
inline constexpr std::size_t kMostPartsDrawn = 300;

/// The file's text. The polygons are drawn in parallel projection from the south-west and above, in
/// the order of the tree's own traversal, as the source paints them: lines on white faces.
std::string bsp_picture(const BspTree& tree);

}  // namespace cigsim
