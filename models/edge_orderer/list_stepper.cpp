// SPDX-License-Identifier: MIT
#include "models/edge_orderer/list_stepper.hpp"

namespace cigsim::edge_orderer {

void ListStepper<Certified>::begin() {
  exact_.clear();
  redone_ = 0;
}

void ListStepper<Certified>::redo(const EdgeList<Certified>& list, std::uint32_t edge, int begin,
                                  int end, int width, std::int32_t* element) {
  const Edge<Certified>& rounded = list.edges[edge];
  if (exact_.empty()) axes_ = ExactAxes(list.view);
  const auto [at, added] = exact_.try_emplace(edge);
  if (added) at->second = ExactLine(list, axes_, rounded);
  const ExactLine& exact = at->second;
  const std::uint64_t before = redone_;
  std::int32_t last = 0;
  for (int r = begin; r < end; ++r) {
    if (step_certain(rounded, r, r + 1, width, element + (r - begin))) continue;
    if (redone_ == before || !exact.upright()) last = exact.element(r, width);
    element[r - begin] = last;
    ++redone_;
  }
}

}  // namespace cigsim::edge_orderer
