// SPDX-License-Identifier: MIT
// An edge from line to line: the first element at or right of it on each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "models/boundary/transactions.hpp"

namespace cigsim::edge_orderer {

/// Writes to element[0 .. end_line - first_line) the smallest whole number not below the edge's
/// crossing, clamped to 0..width.
template <std::floating_point N>
inline void step_edge(const Edge<N>& edge, int width, std::int32_t* element) {
  const N limit = static_cast<N>(width), x = edge.x, slope = edge.slope;
  const int count = edge.end_line - edge.first_line;
  for (int k = 0; k < count; ++k) {
    const N at = std::ceil(x + slope * static_cast<N>(k));
    element[k] = static_cast<std::int32_t>(at > 0 ? (at < limit ? at : limit) : N(0));
  }
}

/// The same without rounding: x and slope over one denominator, and a whole remainder carried from
/// line to line.
inline void step_edge(const Edge<Exact>& edge, int width, std::int32_t* element) {
  mpz_class denominator;
  mpz_lcm(denominator.get_mpz_t(), edge.x.get_den_mpz_t(), edge.slope.get_den_mpz_t());
  const mpz_class start = edge.x.get_num() * (denominator / edge.x.get_den());
  const mpz_class step = edge.slope.get_num() * (denominator / edge.slope.get_den());
  // element = ceil(value / denominator): quotient up, remainder value - quotient * denominator <= 0.
  mpz_class quotient, remainder, step_quotient, step_remainder;
  mpz_cdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), start.get_mpz_t(),
              denominator.get_mpz_t());
  mpz_cdiv_qr(step_quotient.get_mpz_t(), step_remainder.get_mpz_t(), step.get_mpz_t(),
              denominator.get_mpz_t());
  const int count = edge.end_line - edge.first_line;
  for (int k = 0; k < count; ++k) {
    element[k] = sgn(quotient) <= 0      ? 0
                 : quotient >= width     ? width
                                         : static_cast<std::int32_t>(quotient.get_si());
    quotient += step_quotient;
    remainder += step_remainder;
    if (remainder <= -denominator) {
      remainder += denominator;
      --quotient;
    }
  }
}

}  // namespace cigsim::edge_orderer
