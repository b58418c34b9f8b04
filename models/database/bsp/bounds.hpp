// SPDX-License-Identifier: MIT
// How large a BSP tree can become (Fuchs, Kedem, Naylor 1980, Table 2 and the formulas above it),
// for n dividing objects in a space of two (lines) or three dimensions (planes).
//
// The table's first column is the number of leaves of a tree. Its other two count the pieces of the
// arrangement, where every object is cut by the planes of all others; a tree never reaches them in
// space, because an object is cut by the planes chosen before it only: most_nodes is the bound of
// the tree, and it is sharp for bounded objects too.
#pragma once

#include <cstdint>

namespace cigsim {

/// n over k. Exact while the result fits 64 bits (n up to 2,000,000 for k = 3).
constexpr std::uint64_t combinations(std::uint64_t n, std::uint64_t k) {
  std::uint64_t result = 1;
  for (std::uint64_t i = 0; i < k; ++i) result = n < i ? 0 : result * (n - i) / (i + 1);
  return result;
}

/// "Volumes": regions into which n hyperplanes part the space, the sum of C(n, i) for i = 0..d.
constexpr std::uint64_t most_volumes(unsigned d, std::uint64_t n) {
  std::uint64_t sum = 0;
  for (unsigned i = 0; i <= d; ++i) sum += combinations(n, i);
  return sum;
}

/// "Unbounded objects": pieces into which n hyperplanes cut each other, n times the regions of a
/// space of one dimension less that n - 1 hyperplanes make.
constexpr std::uint64_t most_unbounded_pieces(unsigned d, std::uint64_t n) {
  return n == 0 ? 0 : n * most_volumes(d - 1, n - 1);
}

/// "Bounded objects": pieces into which the planes of n bounded convex objects, no two of which
/// meet, cut these objects: C(n, d) + n^(d-1).
constexpr std::uint64_t most_bounded_pieces(unsigned d, std::uint64_t n) {
  std::uint64_t power = 1;
  for (unsigned i = 1; i < d; ++i) power *= n;
  return combinations(n, d) + power;
}

/// Inner nodes of a tree, of bounded or unbounded objects: one less than its leaves.
constexpr std::uint64_t most_nodes(unsigned d, std::uint64_t n) { return most_volumes(d, n) - 1; }

}  // namespace cigsim
