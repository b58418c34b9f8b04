// SPDX-License-Identifier: MIT
// What the scan-line algorithms have in common (Sandor 1979, sec. 5.2, "depth-last sort"): edges
// sorted by the line on which they begin, a list of active edges that is carried from line to line,
// and its order along the line.
#pragma once

#include <vector>

#include "models/survey/visible_surface/algorithm.hpp"

namespace cigsim::survey {

/// An active edge on the current line.
struct LineEdge {
  std::uint32_t edge = 0, face = 0;
  std::uint16_t element = 0;
  bool left = false;
};

/// How the active edges of a line are put in order.
enum class XSort {
  kBubble,       ///< neighbours exchanged, from the order of the line before; new edges merged in
  kDistribution  ///< counted into a bucket an element, afresh on each line
};

class ScanLines {
 public:
  ScanLines(const FaceList& list, XSort sort, Work& work);

  /// Goes on to the next line, from 0.
  void next();
  /// In the order of elements; at one element right edges come first. Edges of a face that covers
  /// no element of the line are left out.
  const std::vector<LineEdge>& edges() const { return sorted_; }
  /// The same edges in the same order as on the line before, if not at the same elements.
  bool same_order() const { return same_order_; }

 private:
  void place(LineEdge& edge) const;
  void enter();
  void bubble();
  void merge();
  void distribute();

  const FaceList& list_;
  XSort sort_;
  Work& work_;
  int line_ = -1;
  std::vector<std::uint32_t> by_line_;  // edges in the order of their first lines
  std::vector<std::uint32_t> first_;    // by line: into by_line_
  std::vector<LineEdge> active_, entered_, sorted_, before_;
  std::vector<std::uint32_t> buckets_;
  bool same_order_ = false;
};

/// Faces between their two edges on a line.
class ActiveFaces {
 public:
  explicit ActiveFaces(std::size_t faces) : at_(faces, kNone) {}

  void pass(const LineEdge& edge) {
    if (edge.left == (at_[edge.face] != kNone)) return;
    if (edge.left) {
      at_[edge.face] = static_cast<std::uint32_t>(faces_.size());
      faces_.push_back(edge.face);
      return;
    }
    const std::uint32_t at = at_[edge.face], last = faces_.back();
    faces_[at] = last;
    at_[last] = at;
    faces_.pop_back();
    at_[edge.face] = kNone;
  }
  const std::vector<std::uint32_t>& faces() const { return faces_; }

 private:
  std::vector<std::uint32_t> faces_, at_;
};

/// Calls span(first, end, faces) for the spans of a line between places where faces begin or end.
template <class Span>
void for_each_span(const std::vector<LineEdge>& edges, ActiveFaces& active, Span span) {
  for (std::size_t i = 0; i < edges.size();) {
    const int element = edges[i].element;
    for (; i < edges.size() && edges[i].element == element; ++i) active.pass(edges[i]);
    if (!active.faces().empty()) span(element, int{edges[i].element}, active.faces());
  }
}

}  // namespace cigsim::survey
