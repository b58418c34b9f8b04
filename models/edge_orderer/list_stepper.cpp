// SPDX-License-Identifier: MIT
#include "models/edge_orderer/list_stepper.hpp"

namespace cigsim::edge_orderer {

void ListStepper<Certified>::begin() {
  for (const std::uint32_t edge : edges_) places_[edge] = kNone;
  edges_.clear();
  lines_.clear();
  redone_ = 0;
}

void ListStepper<Certified>::redo(const EdgeList<Certified>& list, std::uint32_t edge, int begin,
                                  int end, int width, std::int32_t* element) {
  const CertainStep step(list.edges[edge], width);
  const std::uint64_t before = redone_;
  const auto redo_with = [&](const auto& line) {
    std::int32_t last = 0;
    for (int r = begin; r < end; ++r) {
      if (step.take(r, element[r - begin])) continue;
      if (redone_ == before || !line.upright()) last = line.element(r, width);
      element[r - begin] = last;
      ++redone_;
    }
  };
  std::visit(redo_with, exact_line(list, edge));
}

const ListStepper<Certified>::Line& ListStepper<Certified>::exact_line(
    const EdgeList<Certified>& list, std::uint32_t edge) {
  if (lines_.empty()) {
    axes_ = ExactAxes(list.view);
    short_view_ = ShortView(list.view);
  }
  if (places_.size() < list.edges.size()) places_.resize(list.edges.size(), kNone);
  std::uint32_t& place = places_[edge];
  if (place == kNone) {
    place = static_cast<std::uint32_t>(lines_.size());
    edges_.push_back(edge);
    lines_.push_back(make_line(list, list.edges[edge]));
  }
  return lines_[place];
}

ListStepper<Certified>::Line ListStepper<Certified>::make_line(const EdgeList<Certified>& list,
                                                               const Edge<Certified>& edge) const {
  const FaceSet& set = *list.sets[static_cast<std::size_t>(edge.set)];
  if (edge.from != kNone && set.exact(edge.from) == nullptr && set.exact(edge.to) == nullptr)
    if (const auto line =
            short_view_.line(set.vertices[edge.from], set.vertices[edge.to], edge.first_line))
      return *line;
  return ExactLine(list, axes_, edge);
}

}  // namespace cigsim::edge_orderer
