// SPDX-License-Identifier: MIT
// Random numbers that are the same on every machine: SplitMix64 (Steele, Lea, Flood 2014), and
// arithmetic that IEEE 754 rounds alike everywhere.
#pragma once

#include <cstdint>

#include "models/numeric/vec3.hpp"

namespace cigsim {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  /// From 0 to below n; n at most 2^32.
  std::uint32_t below(std::uint64_t n) {
    return static_cast<std::uint32_t>((bits() >> 32) * n >> 32);
  }
  /// From 0 to below 1, a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t state_;
};

}  // namespace cigsim
