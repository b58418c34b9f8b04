// SPDX-License-Identifier: MIT
// The edges of a frame's list from line to line. Those of certified frames are stepped in doubles;
// lines on which the crossing lies within its error bound of a sample are stepped again exactly.
#pragma once

#include <variant>
#include <vector>

#include "models/edge_orderer/exact_line.hpp"
#include "models/edge_orderer/short_line.hpp"
#include "models/edge_orderer/stepper.hpp"

namespace cigsim::edge_orderer {

template <class N>
class ListStepper {
 public:
  /// A new list: nothing is known of its edges.
  void begin() {}
  /// step_edge() of an edge of the list.
  void step(const EdgeList<N>& list, std::uint32_t edge, int begin, int end, int width,
            std::int32_t* element) {
    step_edge(list.edges[edge], begin, end, width, element);
  }
};

template <>
class ListStepper<Certified> {
 public:
  void begin();
  void step(const EdgeList<Certified>& list, std::uint32_t edge, int begin, int end, int width,
            std::int32_t* element) {
    if (!step_certain(list.edges[edge], begin, end, width, element))
      redo(list, edge, begin, end, width, element);
  }

  /// Crossings that were worked out exactly since begin().
  std::uint64_t redone() const { return redone_; }

 private:
  // An edge without rounding, in whichever numbers hold it.
  using Line = std::variant<ShortLine, ExactLine>;

  void redo(const EdgeList<Certified>& list, std::uint32_t edge, int begin, int end, int width,
            std::int32_t* element);
  const Line& exact_line(const EdgeList<Certified>& list, std::uint32_t edge);
  Line make_line(const EdgeList<Certified>& list, const Edge<Certified>& edge) const;

  // Of the list's view, once an edge was needed.
  ExactAxes axes_;
  ShortView short_view_;
  std::vector<Line> lines_;            // of the edges that were needed
  std::vector<std::uint32_t> edges_;   // which these are
  std::vector<std::uint32_t> places_;  // by edge: its line in lines_, or kNone
  std::uint64_t redone_ = 0;
};

}  // namespace cigsim::edge_orderer
