// SPDX-License-Identifier: MIT
#include "models/edge_orderer/sorting_memory.hpp"

#include <algorithm>
#include <cassert>

namespace cigsim::edge_orderer {

void SortingMemory::place(const Cell& cell) {
  cells_.insert(std::upper_bound(cells_.begin(), cells_.end(), cell), cell);
  held_ = static_cast<std::uint32_t>(cells_.size());
}

std::uint32_t SortingMemory::insert(const Cell& cell, LineRegisters& line) {
  assert(!filled_);
  const bool full = capacity_ > 0 && cells_.size() == capacity_;
  switch (policy_) {
    case OverloadPolicy::kDrop:
      if (cell.face >= line.limit) return 1;
      if (full) return clear_from_highest_face(cell, line);
      break;
    case OverloadPolicy::kCut:
    case OverloadPolicy::kExtend:
      if (line.marked && cell <= line.mark) return 0;
      if (!full) break;
      const Cell pushed_out = std::max(cell, cells_.back());
      if (cell < cells_.back()) {
        cells_.pop_back();
        place(cell);
      }
      if (policy_ == OverloadPolicy::kExtend) return 0;
      line.rest = line.cut ? std::min(line.rest, pushed_out) : pushed_out;
      line.cut = true;
      return 1;
  }
  place(cell);
  return 0;
}

// All cells are full, and `cell` is one more.
std::uint32_t SortingMemory::clear_from_highest_face(const Cell& cell, LineRegisters& line) {
  const auto before = static_cast<std::uint32_t>(cells_.size()) + 1;
  line.limit = cell.face;
  for (const Cell& held : cells_) line.limit = std::max(line.limit, held.face);
  std::erase_if(cells_, [&](const Cell& held) { return held.face >= line.limit; });
  if (cell.face < line.limit) place(cell);
  held_ = static_cast<std::uint32_t>(cells_.size());
  return before - held_;
}

void SortingMemory::close(bool line_end, LineRegisters& line) {
  assert(std::is_sorted(cells_.begin(), cells_.end()));
  assert(capacity_ == 0 || cells_.size() <= capacity_);
  assert(line_end || !cells_.empty());
  filled_ = true;
  end_ = {};
  end_.end = line_end;
  end_.cut = line.cut;
  if (line.cut) end_.element = line.rest.element;
  if (line_end) {
    line = {};
  } else {
    line.marked = true;
    line.mark = cells_.back();
  }
}

CrossingWord SortingMemory::front() const {
  assert(filled_);
  if (first_ == cells_.size()) return end_;
  const Cell& cell = cells_[first_];
  return {cell.face, cell.element, cell.left, false, false};
}

bool SortingMemory::shift() {
  assert(filled_);
  const bool end_word = first_ == cells_.size();
  if (!end_word) {
    ++first_;
    --held_;
  }
  if (!end_word && (first_ < cells_.size() || end_.end)) return false;
  cells_.clear();
  first_ = 0;
  filled_ = false;
  return true;
}

}  // namespace cigsim::edge_orderer
