// SPDX-License-Identifier: MIT
// Filling runs of elements in blocks.
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/boundary/transactions.hpp"

namespace cigsim::video_processor {

inline std::uint32_t packed(const Colour& c) {
  return 0xff000000u | std::uint32_t{c.b} << 16 | std::uint32_t{c.g} << 8 | c.r;
}

inline std::uint16_t number_of(std::uint32_t object) {
  return static_cast<std::uint16_t>(std::min(object, 65535u));
}

/// Fills whole blocks of W elements, the last of which may overlap the one before; shorter runs in
/// smaller blocks.
template <class T, int W>
[[gnu::always_inline]] inline void fill(T* first, int count, T value) {
  if constexpr (W == 1) {
    if (count == 1) *first = value;
  } else if (count < W) {
    fill<T, W / 2>(first, count, value);
  } else {
    typedef T Block __attribute__((vector_size(W * sizeof(T)), aligned(alignof(T)), may_alias));
    const Block block = value - Block{};
    for (int i = 0; i + W <= count; i += W) *reinterpret_cast<Block*>(first + i) = block;
    *reinterpret_cast<Block*>(first + count - W) = block;
  }
}

/// A run in both pictures.
[[gnu::always_inline]] inline void fill_run(std::uint32_t* colours, std::uint16_t* numbers,
                                            int count, std::uint32_t colour, std::uint16_t number) {
  fill<std::uint32_t, 8>(colours, count, colour);
  fill<std::uint16_t, 16>(numbers, count, number);
}

}  // namespace cigsim::video_processor
