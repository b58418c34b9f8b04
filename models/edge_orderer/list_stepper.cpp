// SPDX-License-Identifier: MIT
#include "models/edge_orderer/list_stepper.hpp"

#include <algorithm>

namespace cigsim::edge_orderer {
namespace {

ExactVec viewpoint_position(const FaceSet& set, std::uint32_t vertex, const ViewTransform& view) {
  const ExactVec* cut = set.exact(vertex);
  const ExactVec at = cut != nullptr ? *cut : convert<Exact>(set.vertices[vertex]);
  return convert<Exact>(view.rotation) * (at - convert<Exact>(view.eye));
}

}  // namespace

// With n the cross product of the two positions in the viewpoint system, a sample (x, y) of the
// raster, which is the direction (focal, x - width/2, height/2 - y), lies in the plane where
// n_u focal + n_v (x - width/2) + n_w (height/2 - y) = 0. The edge is not level, so n_v is not 0.
Edge<Exact> exact_edge(const EdgeList<Certified>& list, const Edge<Certified>& edge) {
  if (edge.from == kNone) return list.exact[edge.to];
  const FaceSet& set = *list.sets[static_cast<std::size_t>(edge.set)];
  const ViewTransform& view = list.view;
  const ExactVec n =
      cross(viewpoint_position(set, edge.from, view), viewpoint_position(set, edge.to, view));
  Edge<Exact> out{edge.first_line, edge.end_line, edge.left, {}, {}};
  out.slope = n.z / n.y;
  const Exact rise = Exact(edge.first_line + 0.5 - view.raster.height / 2.0);
  out.x = Exact((view.raster.width - 1) / 2.0) + out.slope * rise - Exact(view.focal) * n.x / n.y;
  return out;
}

void ListStepper<Certified>::begin() {
  exact_.clear();
  redone_ = 0;
}

const Edge<Exact>& ListStepper<Certified>::exact_edge(const EdgeList<Certified>& list,
                                                      std::uint32_t edge) {
  const auto [at, added] = exact_.try_emplace(edge);
  if (added) at->second = edge_orderer::exact_edge(list, list.edges[edge]);
  return at->second;
}

// From the first line in doubt to the last.
void ListStepper<Certified>::redo(const EdgeList<Certified>& list, std::uint32_t edge, int begin,
                                  int end, int width, std::int32_t* element) {
  int first = end, last = begin;
  for (int r = begin; r < end; ++r) {
    std::int32_t one;
    if (step_certain(list.edges[edge], r, r + 1, width, &one)) continue;
    first = std::min(first, r);
    last = r;
    ++redone_;
  }
  if (first <= last)
    step_edge(exact_edge(list, edge), first, last + 1, width, element + (first - begin));
}

}  // namespace cigsim::edge_orderer
