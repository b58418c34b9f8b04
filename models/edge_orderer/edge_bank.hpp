// SPDX-License-Identifier: MIT
// A bank of the edge memory at the functional and timed levels: a picture's edges, in a bucket for
// each line on which edges begin (Sandor 1979: the sort by first line).
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "models/boundary/words.hpp"

namespace cigsim::edge_orderer {

class EdgeBank {
 public:
  explicit EdgeBank(int height) : first_(static_cast<std::size_t>(height), kNone) {}

  /// Puts an edge, not an end word, into the bucket of its first line.
  void add(const EdgeWord& edge) {
    assert(edge.first_line < edge.end_line && edge.end_line <= first_.size());
    next_.push_back(first_[edge.first_line]);
    first_[edge.first_line] = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back(edge);
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(edges_.size()); }
  const EdgeWord& edge(std::uint32_t place) const { return edges_[place]; }

  /// Empties the bucket of a line and hands its edges' places to use(place).
  template <class Use>
  void empty_bucket(int line, Use use) {
    std::uint32_t& first = first_[static_cast<std::size_t>(line)];
    for (; first != kNone; first = next_[first]) use(first);
  }
  /// For the next picture; all buckets must have been emptied.
  void clear() {
    edges_.clear();
    next_.clear();
  }

 private:
  std::vector<EdgeWord> edges_;
  std::vector<std::uint32_t> next_;   ///< by place: the next edge of the bucket
  std::vector<std::uint32_t> first_;  ///< by line
};

}  // namespace cigsim::edge_orderer
