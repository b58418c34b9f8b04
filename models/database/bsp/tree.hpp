// SPDX-License-Identifier: MIT
// A binary space partitioning tree of polygons (Fuchs, Kedem, Naylor 1980, "Preprocessing phase").
//
// Each inner node has a plane. The polygons that lie in it stand at the node, whichever way they
// face; those (or the parts of those) on either side are in the two subtrees. The source puts a
// coplanar polygon "into either set"; here it stays at the node, which saves nodes and leaves their
// count of polygons alone. A node without polygons is a dividing plane (the hybrid that the source
// proposes in "Comparison of uses").
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/work_set.hpp"

namespace cigsim {

struct BspNode {
  static constexpr std::uint32_t kLeaf = 0xffffffffu;

  std::uint32_t plane = 0;             ///< into BspTree::set.planes
  std::uint32_t first = 0, count = 0;  ///< into BspTree::members, in the order of the scene
  std::uint32_t positive = kLeaf;      ///< subtree on the normal's side
  std::uint32_t negative = kLeaf;
};

struct BspTree {
  WorkSet set;                         ///< polygons, those that were cut and their parts
  std::vector<BspNode> nodes;          ///< [0] is the root; a child follows its parent
  std::vector<std::uint32_t> members;  ///< items of `set`, one polygon each
  std::uint64_t polygons = 0;          ///< that went in
  std::uint64_t splits = 0;            ///< times that a plane cut a polygon in two
  std::uint64_t dividing_planes = 0;   ///< nodes without a polygon
  std::uint64_t depth = 0;             ///< nodes on the longest way from the root

  /// Leaves, which the tree does not store: one for each empty son.
  std::uint64_t leaves() const { return nodes.size() + 1; }
  const WorkPolygon& polygon(std::uint32_t item) const {
    return set.polygons[set.items[item].first_polygon];
  }
};

}  // namespace cigsim
