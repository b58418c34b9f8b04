// SPDX-License-Identifier: MIT
// The lists that a picture really asks a hidden-surface algorithm to sort (Sandor 1979, sec. 5.2
// and 5.3).
#pragma once

#include <string_view>
#include <vector>

#include "models/survey/sorting/sorts.hpp"
#include "models/survey/visible_surface/face_list.hpp"

namespace cigsim::survey {

struct SortLists {
  std::string_view name, meaning;
  std::vector<std::vector<Record>> lists;
  std::uint64_t records = 0;  ///< of all lists
};

/// In this order:
///  - "Y": all edges by their first line, as they stand in the database;
///  - "X, line to line": on each line the crossings by element, in the order that they had on the
///    line before, new ones inserted where the line has them;
///  - "X, afresh": the same crossings in the order of the database;
///  - "Z": all faces by their farthest depth, a key of 32 bits.
std::vector<SortLists> scene_lists(const FaceList& list);

}  // namespace cigsim::survey
