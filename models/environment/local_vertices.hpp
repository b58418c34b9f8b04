// SPDX-License-Identifier: MIT
// Numbering an object's vertices for itself, out of the numbering of a whole file.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace cigsim {

/// Maps the file's vertex numbers to an object's own, in the file's order and without gaps. The
/// work for an object depends on that object alone, however many vertices the file has.
class LocalVertices {
 public:
  explicit LocalVertices(std::size_t file_vertices) : local_(file_vertices, kUnused) {}

  /// Starts an object whose faces use the given vertices of the file. Returns these, each once,
  /// ascending: the local numbers are the places in it.
  const std::vector<std::uint32_t>& begin_object(std::span<const std::uint32_t> corners) {
    used_.clear();
    for (const std::uint32_t v : corners)
      if (local_[v] == kUnused) {
        local_[v] = 0;
        used_.push_back(v);
      }
    if (!std::is_sorted(used_.begin(), used_.end())) std::sort(used_.begin(), used_.end());
    for (std::size_t i = 0; i < used_.size(); ++i) local_[used_[i]] = static_cast<std::uint32_t>(i);
    return used_;
  }

  std::uint32_t operator[](std::uint32_t file_vertex) const { return local_[file_vertex]; }

  void end_object() {
    for (const std::uint32_t v : used_) local_[v] = kUnused;
  }

 private:
  static constexpr std::uint32_t kUnused = 0xffffffff;
  std::vector<std::uint32_t> local_;
  std::vector<std::uint32_t> used_;
};

}  // namespace cigsim
