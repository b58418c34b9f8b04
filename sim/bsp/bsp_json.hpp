// SPDX-License-Identifier: MIT
// A BSP tree as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "models/database/bsp/tree.hpp"

namespace cigsim {

/// "polygons" (name, object from 1, polygon from 1, node, vertices in environment units, priority
/// where `priorities` are given) in the order of BspTree::members, and "nodes" (a point of the
/// plane, its normal, of any length; places in "polygons"; "positive" and "negative" sons or null),
/// the root first. Vertices and normals are rounded to doubles.
nlohmann::ordered_json bsp_tree_json(const BspTree& tree,
                                     const std::optional<std::vector<std::uint32_t>>& priorities);

}  // namespace cigsim
