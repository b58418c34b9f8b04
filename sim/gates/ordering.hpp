// SPDX-License-Identifier: MIT
// How many objects hardware of some size orders in a given time.
#pragma once

#include <cstdint>

namespace cigsim::gates {

/// How much of the SO matrix is worked out in a step.
enum class Way {
  kPair,   ///< one pair; the matrix is anti-symmetric, so that n (n - 1) / 2 steps do
  kRow,    ///< an object against `width` others: n times the steps for a row
  kMatrix  ///< `width` objects against `width` others
};

/// Steps for the matrix of n objects by hardware that is `width` objects wide.
std::uint64_t steps_for(Way way, std::uint64_t objects, std::uint64_t width);

/// The most objects that `steps` are enough for.
std::uint64_t objects_in(Way way, std::uint64_t steps, std::uint64_t width);

}  // namespace cigsim::gates
