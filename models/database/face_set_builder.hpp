// SPDX-License-Identifier: MIT
// From the working set to the flat arrays of a face set.
#pragma once

#include "models/database/database.hpp"
#include "models/database/work_set.hpp"

namespace cigsim {

class FaceSetBuilder {
 public:
  /// Both must outlive the builder; the working set may grow between calls.
  FaceSetBuilder(const WorkSet& work, FaceSet& out) : work_(work), out_(out) {}

  /// Makes one item of working items whose order is the order of their priority; returns its index.
  std::uint32_t add(const std::vector<std::uint32_t>& work_items);
  /// Makes an item without faces or vertices.
  void add_placeholder();

 private:
  void add_face(const WorkPolygon& polygon, std::uint32_t first_vertex);
  std::uint32_t local_vertex(std::uint32_t vertex, std::uint32_t first_vertex);

  const WorkSet& work_;
  FaceSet& out_;
  std::vector<std::uint32_t> local_, plane_of_;  // kNone: not yet there
  std::vector<std::uint32_t> used_;
};

}  // namespace cigsim
