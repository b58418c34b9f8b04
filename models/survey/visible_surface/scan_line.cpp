// SPDX-License-Identifier: MIT
#include "models/survey/visible_surface/scan_line.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace cigsim::survey {
namespace {

// Order along a line. Edges at one element keep an order of their own, so that it stays the same
// from line to line.
bool before(const LineEdge& a, const LineEdge& b) {
  return std::tuple(a.element, a.left, a.face) < std::tuple(b.element, b.left, b.face);
}

}  // namespace

ScanLines::ScanLines(const FaceList& list, XSort sort, Work& work)
    : list_(list), sort_(sort), work_(work) {
  const std::size_t lines = static_cast<std::size_t>(list.raster.height);
  first_.assign(lines + 1, 0);
  for (const SurveyEdge& edge : list.edges) ++first_[static_cast<std::size_t>(edge.first_line) + 1];
  for (std::size_t r = 0; r < lines; ++r) first_[r + 1] += first_[r];
  by_line_.resize(list.edges.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t e = 0; e < list.edges.size(); ++e)
    by_line_[next[static_cast<std::size_t>(list.edges[e].first_line)]++] = e;
  work.edges += list.edges.size();
  work.faces += list.faces.size();
  ++work.sorts;  // by distribution: no comparisons
}

void ScanLines::place(LineEdge& edge) const {
  const Row& row = list_.row(list_.faces[edge.face], line_);
  edge.element = edge.left ? row.first : row.end;
}

void ScanLines::next() {
  ++line_;
  std::erase_if(active_,
                [this](const LineEdge& e) { return list_.edges[e.edge].end_line <= line_; });
  for (LineEdge& edge : active_) place(edge);
  enter();
  if (!active_.empty() || !entered_.empty()) ++work_.sorts;
  if (sort_ == XSort::kBubble) {
    bubble();
    merge();
  } else {
    active_.insert(active_.end(), entered_.begin(), entered_.end());
    distribute();
  }
  before_.swap(sorted_);
  sorted_.clear();
  for (const LineEdge& edge : active_) {
    const Row& row = list_.row(list_.faces[edge.face], line_);
    if (row.first < row.end) sorted_.push_back(edge);
  }
  same_order_ = std::equal(
      sorted_.begin(), sorted_.end(), before_.begin(), before_.end(),
      [](const LineEdge& a, const LineEdge& b) { return a.face == b.face && a.left == b.left; });
}

void ScanLines::enter() {
  entered_.clear();
  for (std::size_t i = first_[static_cast<std::size_t>(line_)];
       i < first_[static_cast<std::size_t>(line_) + 1]; ++i) {
    const std::uint32_t e = by_line_[i];
    entered_.push_back({e, list_.edges[e].face, 0, list_.edges[e].left});
    place(entered_.back());
  }
}

void ScanLines::bubble() {
  for (std::size_t i = 1; i < active_.size(); ++i)
    for (std::size_t k = i; k > 0; --k) {
      ++work_.comparisons;
      if (!before(active_[k], active_[k - 1])) break;
      std::swap(active_[k], active_[k - 1]);
    }
}

void ScanLines::merge() {
  const auto counted = [this](const LineEdge& a, const LineEdge& b) {
    ++work_.comparisons;
    return before(a, b);
  };
  std::sort(entered_.begin(), entered_.end(), counted);
  std::vector<LineEdge> merged;
  merged.reserve(active_.size() + entered_.size());
  std::merge(active_.begin(), active_.end(), entered_.begin(), entered_.end(),
             std::back_inserter(merged), counted);
  active_ = std::move(merged);
}

void ScanLines::distribute() {
  const auto bucket = [](const LineEdge& e) { return 2 * std::size_t{e.element} + e.left; };
  buckets_.assign(2 * static_cast<std::size_t>(list_.raster.width) + 3, 0);
  for (const LineEdge& e : active_) ++buckets_[bucket(e) + 1];
  for (std::size_t b = 1; b < buckets_.size(); ++b) buckets_[b] += buckets_[b - 1];
  std::vector<LineEdge> ordered(active_.size());
  for (const LineEdge& e : active_) ordered[buckets_[bucket(e)]++] = e;
  active_ = std::move(ordered);
}

}  // namespace cigsim::survey
