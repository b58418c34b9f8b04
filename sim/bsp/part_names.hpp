// SPDX-License-Identifier: MIT
// What the polygons of a BSP tree are called: A, B, C as in Fuchs, Kedem, Naylor 1980, figs. 6 to 8
// (numbers from 1 where there are more than 26), and A1, A2 (1.1, 1.2) for the parts of one that
// was split, in the order of the tree.
#pragma once

#include <string>
#include <vector>

#include "models/database/bsp/tree.hpp"

namespace cigsim {

/// A name for each of BspTree::members.
std::vector<std::string> part_names(const BspTree& tree);

}  // namespace cigsim
