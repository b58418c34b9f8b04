// SPDX-License-Identifier: MIT
// Whether two pictures show the same thing.
#pragma once

#include "models/boundary/transactions.hpp"

namespace cigsim::benchmarks {

struct Agreement {
  std::uint64_t elements = 0;
  std::uint64_t differing = 0;  ///< in colour or in object number
  std::uint64_t astray = 0;  ///< of these: what the other shows is in none of the elements around

  double share() const { return static_cast<double>(differing) / static_cast<double>(elements); }
  Agreement& operator+=(const Agreement& more);
};

Agreement compare(const Picture& reference, const Picture& other);

}  // namespace cigsim::benchmarks
