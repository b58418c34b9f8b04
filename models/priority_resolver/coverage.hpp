// SPDX-License-Identifier: MIT
// The resolver's spans by another road: faces in order of priority, each against a mask of the
// elements that are taken on a line. A convex face has one left and one right crossing on a line,
// so no crossing need be sorted; the spans are those of the active list.
#pragma once

#include <bit>

#include "models/edge_orderer/stepper.hpp"
#include "models/priority_resolver/spans.hpp"

namespace cigsim::priority_resolver {

/// A bit an element, a row of words a line.
class CoverageMask {
 public:
  void reset(const Raster& raster) {
    words_per_line_ = (static_cast<std::size_t>(raster.width) + 63) / 64;
    words_.assign(words_per_line_ * static_cast<std::size_t>(raster.height), 0);
  }

  /// Takes the free elements of [first, end) and calls show(a, b) for each run of them.
  template <class Show>
  void take(int line, int first, int end, Show show) {
    std::uint64_t* words = words_.data() + static_cast<std::size_t>(line) * words_per_line_;
    const int last_word = (end - 1) / 64;
    int run = -1;  // start of a run that reached the end of the word before
    for (int w = first / 64; w <= last_word; ++w) {
      const std::uint64_t above =
          w == first / 64 ? ~std::uint64_t{0} << (first % 64) : ~std::uint64_t{0};
      const std::uint64_t below =
          w == last_word ? ~std::uint64_t{0} >> (63 - (end - 1) % 64) : ~std::uint64_t{0};
      std::uint64_t open = above & below & ~words[w];
      words[w] |= open;
      if (run >= 0 && !(open & 1)) {
        show(run, w * 64);
        run = -1;
      }
      while (open != 0) {
        const int from = std::countr_zero(open);
        const int length = std::countr_one(open >> from);
        const int start = run >= 0 ? run : w * 64 + from;
        run = -1;
        if (from + length == 64) {
          run = start;
          break;
        }
        show(start, w * 64 + from + length);
        open &= ~std::uint64_t{0} << (from + length);
      }
    }
    if (run >= 0) show(run, end);
  }

 private:
  std::size_t words_per_line_ = 0;
  std::vector<std::uint64_t> words_;
};

template <class N>
class Coverage {
 public:
  /// Faces must be in the order of their priority, highest first. Returns the number of spans that
  /// show a face.
  std::uint64_t compute(const EdgeList<N>& edges, const Raster& raster, SpanLines& out) {
    out.reset(raster.height);
    mask_.reset(raster);
    left_.resize(static_cast<std::size_t>(raster.height));
    right_.resize(static_cast<std::size_t>(raster.height));
    std::uint64_t shown = 0;
    for (std::uint32_t f = 0; f < edges.faces.size(); ++f) {
      const RasterFace& face = edges.faces[f];
      cross(edges, face, raster.width);
      for (int r = face.first_line; r < face.end_line; ++r) {
        if (left_[r] >= right_[r]) continue;
        mask_.take(r, left_[r], right_[r], [&](int first, int end) {
          out.add(r, {f, static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(end)});
          ++shown;
        });
      }
    }
    for (int r = 0; r < raster.height; ++r)
      mask_.take(r, 0, raster.width, [&](int first, int end) {
        out.add(r, {kNone, static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(end)});
      });
    return shown;
  }

 private:
  void cross(const EdgeList<N>& edges, const RasterFace& face, int width) {
    for (std::uint32_t e = face.first_edge; e < face.first_edge + face.edge_count; ++e) {
      const Edge<N>& edge = edges.edges[e];
      edge_orderer::step_edge(edge, width, (edge.left ? left_ : right_).data() + edge.first_line);
    }
  }

  CoverageMask mask_;
  std::vector<std::int32_t> left_, right_;
};

}  // namespace cigsim::priority_resolver
