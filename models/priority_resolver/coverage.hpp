// SPDX-License-Identifier: MIT
// The resolver's spans by another road: faces in order of priority, each against a mask of the
// elements that are taken on a line. A convex face has one left and one right crossing on a line,
// so no crossing need be sorted; the spans are those of the active list.
#pragma once

#include <bit>
#include <cstring>

#include "models/edge_orderer/list_stepper.hpp"
#include "models/priority_resolver/spans.hpp"

namespace cigsim::priority_resolver {

/// A bit an element, a row of words a line.
class CoverageMask {
 public:
  void reset(const Raster& raster) {
    width_ = raster.width;
    // A word more than needed, so that a word can be read from any byte of a line.
    words_per_line_ = (static_cast<std::size_t>(raster.width) + 63) / 64 + 1;
    words_.assign(words_per_line_ * static_cast<std::size_t>(raster.height), 0);
  }

  /// Takes the free elements of [first, end) and calls show(a, b) for each run of them.
  template <class Show>
  void take(int line, int first, int end, Show show) {
    if (end - first <= kWindow) {
      take_window(line, first, end, show);
      return;
    }
    Runs<Show> runs{show};
    std::uint64_t* words = this->line(line);
    for (int w = first / 64; w <= (end - 1) / 64; ++w) {
      const std::uint64_t open = within(w, first, end) & ~words[w];
      words[w] |= open;
      runs.add(open, w * 64);
    }
    runs.finish(end);
  }

  /// Calls show(a, b) for each run of free elements of a line.
  template <class Show>
  void rest(int line, Show show) {
    Runs<Show> runs{show};
    const std::uint64_t* words = this->line(line);
    for (int w = 0; w <= (width_ - 1) / 64; ++w) runs.add(within(w, 0, width_) & ~words[w], w * 64);
    runs.finish(width_);
  }

 private:
  // Elements that one unaligned word holds wherever the first lies in its byte.
  static constexpr int kWindow = 57;

  // Joins runs of set bits over consecutive words.
  template <class Show>
  struct Runs {
    Show& show;
    int start = -1;  // of a run that reached the end of the word before

    void add(std::uint64_t open, int first) {
      if (start >= 0 && !(open & 1)) {
        show(start, first);
        start = -1;
      }
      while (open != 0) {
        const int from = std::countr_zero(open), length = std::countr_one(open >> from);
        if (start < 0) start = first + from;
        if (from + length == 64) return;
        show(start, first + from + length);
        start = -1;
        open &= ~std::uint64_t{0} << (from + length);
      }
    }
    void finish(int end) {
      if (start >= 0) show(start, end);
    }
  };

  template <class Show>
  void take_window(int line, int first, int end, Show& show) {
    unsigned char* at = reinterpret_cast<unsigned char*>(this->line(line)) + first / 8;
    std::uint64_t word;
    std::memcpy(&word, at, sizeof word);
    const int shift = first % 8;
    const std::uint64_t wanted = ~std::uint64_t{0} >> (64 - (end - first));
    const std::uint64_t open = wanted & ~(word >> shift);
    word |= wanted << shift;
    std::memcpy(at, &word, sizeof word);
    if (open == wanted) {
      show(first, end);
      return;
    }
    Runs<Show> runs{show};
    runs.add(open, first);
  }

  // The bits of word w that lie in [first, end).
  static std::uint64_t within(int w, int first, int end) {
    std::uint64_t bits = ~std::uint64_t{0};
    if (w == first / 64) bits &= ~std::uint64_t{0} << (first % 64);
    if (w == (end - 1) / 64) bits &= ~std::uint64_t{0} >> (63 - (end - 1) % 64);
    return bits;
  }

  std::uint64_t* line(int line) {
    return words_.data() + static_cast<std::size_t>(line) * words_per_line_;
  }

  int width_ = 0;
  std::size_t words_per_line_ = 0;
  std::vector<std::uint64_t> words_;
};

static_assert(std::endian::native == std::endian::little, "words are also read from any byte");

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
    stepper_.begin();
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
      mask_.rest(r, [&](int first, int end) {
        out.add(r, {kNone, static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(end)});
      });
    return shown;
  }

  /// The stepper of the last frame's edges.
  const edge_orderer::ListStepper<N>& stepper() const { return stepper_; }

 private:
  void cross(const EdgeList<N>& edges, const RasterFace& face, int width) {
    for (std::uint32_t e = face.first_edge; e < face.first_edge + face.edge_count; ++e) {
      const Edge<N>& edge = edges.edges[e];
      stepper_.step(edges, e, edge.first_line, edge.end_line, width,
                    (edge.left ? left_ : right_).data() + edge.first_line);
    }
  }

  edge_orderer::ListStepper<N> stepper_;
  CoverageMask mask_;
  std::vector<std::int32_t> left_, right_;
};

}  // namespace cigsim::priority_resolver
