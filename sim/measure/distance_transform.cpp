// SPDX-License-Identifier: MIT
#include "sim/measure/distance_transform.hpp"

#include <algorithm>

namespace cigsim {
namespace {

using Wide = std::int64_t;

// Distances within each column; `far` where it has no mark, more than any distance in the picture.
std::vector<std::int32_t> column_distances(std::span<const std::uint8_t> marked, int width,
                                           int height, std::int32_t far) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<std::int32_t> d(w * h);
  for (std::size_t c = 0; c < w; ++c) d[c] = marked[c] ? 0 : far;
  for (std::size_t i = w; i < w * h; ++i) d[i] = marked[i] ? 0 : std::min(far, d[i - w] + 1);
  for (std::size_t i = w * (h - 1); i-- > 0;) d[i] = std::min(d[i], d[i + w] + 1);
  return d;
}

// The lower envelope of the parabolas (x - i)^2 + g[i]^2 of a row, evaluated at each x.
class Row {
 public:
  explicit Row(std::size_t width) : parabola_(width), from_(width) {}

  void compute(std::span<const std::int32_t> g, std::span<std::uint32_t> out) {
    const auto width = static_cast<Wide>(g.size());
    std::size_t top = 0;
    parabola_[0] = 0;
    from_[0] = 0;
    for (Wide u = 1; u < width; ++u) {
      bool empty = false;
      while (value(g, parabola_[top], from_[top]) > value(g, u, from_[top])) {
        empty = top == 0;
        if (empty) break;
        --top;
      }
      if (empty) {
        parabola_[0] = u;
        continue;
      }
      // The first x at which u lies below the parabola on top.
      const Wide i = parabola_[top];
      const Wide from = 1 + floor_div(u * u - i * i + square(g, u) - square(g, i), 2 * (u - i));
      if (from >= width) continue;
      ++top;
      parabola_[top] = u;
      from_[top] = from;
    }
    for (Wide x = width; x-- > 0;) {
      out[static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(value(g, parabola_[top], x));
      if (x == from_[top] && top > 0) --top;
    }
  }

 private:
  static Wide square(std::span<const std::int32_t> g, Wide i) {
    const Wide value = g[static_cast<std::size_t>(i)];
    return value * value;
  }
  static Wide value(std::span<const std::int32_t> g, Wide i, Wide x) {
    return (x - i) * (x - i) + square(g, i);
  }
  static Wide floor_div(Wide a, Wide b) { return a / b - (a % b < 0 ? 1 : 0); }

  std::vector<Wide> parabola_, from_;  // which one is lowest, and from which x on
};

}  // namespace

std::vector<std::uint32_t> squared_distances(std::span<const std::uint8_t> marked, int width,
                                             int height) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<std::uint32_t> result(w * h, kNoDistance);
  if (std::none_of(marked.begin(), marked.end(), [](std::uint8_t m) { return m != 0; }))
    return result;
  const std::vector<std::int32_t> columns = column_distances(marked, width, height, width + height);
  Row row(w);
  for (std::size_t r = 0; r < h; ++r)
    row.compute(std::span(columns).subspan(r * w, w), std::span(result).subspan(r * w, w));
  return result;
}

}  // namespace cigsim
