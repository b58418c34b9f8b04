// SPDX-License-Identifier: MIT
#include "models/edge_orderer/stepper.hpp"

#include "models/numeric/dispatch.hpp"

namespace cigsim::edge_orderer {
namespace {

template <class N>
[[gnu::always_inline]] inline void step(const Edge<N>& edge, int begin, int end, int width,
                                        std::int32_t* element) {
  const N limit = static_cast<N>(width), x = edge.x, slope = edge.slope;
  const int skip = begin - edge.first_line;
  for (int k = 0; k < end - begin; ++k) {
    const N at = x + slope * static_cast<N>(skip + k);
    // Clamped first, so that what is converted is in range; NaN becomes 0.
    const N clamped = at > 0 ? (at < limit ? at : limit) : N(0);
    const std::int32_t down = static_cast<std::int32_t>(clamped);
    element[k] = down + (static_cast<N>(down) < clamped);
  }
}

}  // namespace

CIGSIM_DISPATCH
void step_edge(const Edge<float>& edge, int begin, int end, int width, std::int32_t* element) {
  step(edge, begin, end, width, element);
}

CIGSIM_DISPATCH
void step_edge(const Edge<double>& edge, int begin, int end, int width, std::int32_t* element) {
  step(edge, begin, end, width, element);
}

CIGSIM_DISPATCH
bool step_certain(const Edge<Certified>& edge, int begin, int end, int width,
                  std::int32_t* element) {
  const CertainStep step(edge, width);
  int doubts = 0;
  for (int r = begin; r < end; ++r) doubts |= !step.take(r, element[r - begin]);
  return doubts == 0;
}

void step_edge(const Edge<Exact>& edge, int begin, int end, int width, std::int32_t* element) {
  mpz_class denominator;
  mpz_lcm(denominator.get_mpz_t(), edge.x.get_den_mpz_t(), edge.slope.get_den_mpz_t());
  const mpz_class step = edge.slope.get_num() * (denominator / edge.slope.get_den());
  const mpz_class start = edge.x.get_num() * (denominator / edge.x.get_den()) +
                          step * mpz_class(begin - edge.first_line);
  // element = ceil(value / denominator): quotient up, remainder value - quotient * denominator <=
  // 0.
  mpz_class quotient, remainder, step_quotient, step_remainder;
  mpz_cdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), start.get_mpz_t(),
              denominator.get_mpz_t());
  mpz_cdiv_qr(step_quotient.get_mpz_t(), step_remainder.get_mpz_t(), step.get_mpz_t(),
              denominator.get_mpz_t());
  for (int k = 0; k < end - begin; ++k) {
    element[k] = sgn(quotient) <= 0  ? 0
                 : quotient >= width ? width
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
