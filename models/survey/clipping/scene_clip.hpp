// SPDX-License-Identifier: MIT
// Clipping of a whole scene as Sandor 1979 (sec. 4 and 5.1) orders it: clusters first, from the
// root of the hierarchy down, then back faces, then edges and polygons of what was neither inside
// nor outside.
#pragma once

#include "models/boundary/transactions.hpp"
#include "models/survey/clipping/polygon_clip.hpp"

namespace cigsim::survey {

struct ClipCounts {
  struct Clusters {
    std::uint64_t tested = 0, outside = 0, too_small = 0, inside = 0, cut = 0;
  };
  struct Parts {
    std::uint64_t tested = 0, outside = 0, inside = 0, cut = 0;
  };
  Clusters groups;  ///< clusters of clusters
  Clusters items;   ///< of the ground and of moving models too
  /// Items that no test of their own was needed for: within a group that is inside, outside, or too
  /// small.
  std::uint64_t items_inside_groups = 0, items_dropped_with_groups = 0;
  std::uint64_t back_faces = 0;  ///< of items that are cut
  Parts edges, polygons;         ///< of the other faces of items that are cut
  PolygonWork work;
};

/// `view_plane`: its distance, in environment units, greater than 0. A cluster is too small when
/// its image is less than an element wide and high.
ClipCounts clip_scene(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
                      double frame, double view_plane);

}  // namespace cigsim::survey
