// SPDX-License-Identifier: MIT
// The visible spans of a picture, line by line.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "models/boundary/transactions.hpp"

namespace cigsim::priority_resolver {

/// Spans of each line in no order; together they cover every element of the line once.
class SpanLines {
 public:
  void reset(int lines) {
    counts_.assign(static_cast<std::size_t>(lines), 0);
    if (spans_.size() < counts_.size() * stride_) spans_.resize(counts_.size() * stride_);
  }
  void add(int line, const Span& span) {
    std::uint32_t& count = counts_[static_cast<std::size_t>(line)];
    if (count == stride_) widen();
    spans_[static_cast<std::size_t>(line) * stride_ + count++] = span;
  }
  std::span<const Span> line(int line) const {
    return {spans_.data() + static_cast<std::size_t>(line) * stride_,
            counts_[static_cast<std::size_t>(line)]};
  }
  int lines() const { return static_cast<int>(counts_.size()); }

 private:
  void widen() {
    std::vector<Span> wider(counts_.size() * stride_ * 2);
    for (std::size_t l = 0; l < counts_.size(); ++l)
      std::copy_n(spans_.begin() + static_cast<std::ptrdiff_t>(l * stride_), counts_[l],
                  wider.begin() + static_cast<std::ptrdiff_t>(l * stride_ * 2));
    spans_.swap(wider);
    stride_ *= 2;
  }

  std::size_t stride_ = 64;
  std::vector<std::uint32_t> counts_;
  std::vector<Span> spans_;
};

}  // namespace cigsim::priority_resolver
