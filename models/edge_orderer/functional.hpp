// SPDX-License-Identifier: MIT
// Edge orderer, functional level (Stump 1986, ch. II): for each raster line the crossings of all
// edges, ordered by element. On machine words, what becomes of lines with too many crossings is
// reconstruction (docs/machine/edge_orderer.md).
#pragma once

#include <algorithm>
#include <vector>

#include "models/edge_orderer/line_orderer.hpp"
#include "models/edge_orderer/list_stepper.hpp"

namespace cigsim::edge_orderer {

/// Crossings of all lines: those of line r are [first[r], first[r + 1]), ascending by element; at
/// one element right edges come before left ones, and faces in ascending order within each kind.
struct OrderedCrossings {
  std::vector<Crossing> crossings;
  std::vector<std::uint32_t> first;
  std::vector<std::uint16_t> limit;  ///< by line: from this element on it was cut; width: not cut
};

template <class N>
class Functional {
 public:
  void compute(const EdgeList<N>& edges, const Raster& raster, OrderedCrossings& out) {
    out.first.assign(static_cast<std::size_t>(raster.height) + 1, 0);
    for (const Edge<N>& edge : edges.edges)
      for (int r = edge.first_line; r < edge.end_line; ++r) ++out.first[r + 1];
    for (int r = 0; r < raster.height; ++r) out.first[r + 1] += out.first[r];
    out.limit.assign(static_cast<std::size_t>(raster.height),
                     static_cast<std::uint16_t>(raster.width));
    out.crossings.resize(out.first.back());
    next_.assign(out.first.begin(), out.first.end() - 1);
    element_.resize(static_cast<std::size_t>(raster.height));
    stepper_.begin();
    for (std::uint32_t f = 0; f < edges.faces.size(); ++f) {
      const RasterFace& face = edges.faces[f];
      for (std::uint32_t e = face.first_edge; e < face.first_edge + face.edge_count; ++e) {
        const Edge<N>& edge = edges.edges[e];
        stepper_.step(edges, e, edge.first_line, edge.end_line, raster.width, element_.data());
        for (int r = edge.first_line; r < edge.end_line; ++r)
          out.crossings[next_[r]++] = {f, static_cast<std::uint16_t>(element_[r - edge.first_line]),
                                       edge.left};
      }
    }
    for (int r = 0; r < raster.height; ++r)
      std::sort(out.crossings.begin() + out.first[r], out.crossings.begin() + out.first[r + 1],
                [](const Crossing& a, const Crossing& b) {
                  if (a.element != b.element) return a.element < b.element;
                  if (a.left != b.left) return b.left;
                  return a.face < b.face;
                });
  }

  /// The stepper of the last frame's edges.
  const ListStepper<N>& stepper() const { return stepper_; }

 private:
  ListStepper<N> stepper_;
  std::vector<std::uint32_t> next_;
  std::vector<std::int32_t> element_;
};

/// On machine words, by the rules EO1 to EO4.
template <>
class Functional<MachineWord> {
 public:
  /// `capacity`: crossings of a line, 0: no limit.
  explicit Functional(std::uint32_t capacity = 0, OverloadPolicy policy = OverloadPolicy::kDrop)
      : capacity_(capacity), policy_(policy) {}

  /// Returns what happened; frame number and activity are zero.
  Figures compute(const EdgeList<MachineWord>& edges, const Raster& raster, OrderedCrossings& out);

 private:
  std::uint32_t capacity_;
  OverloadPolicy policy_;
};

}  // namespace cigsim::edge_orderer
