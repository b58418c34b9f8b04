// SPDX-License-Identifier: MIT
#include "sim/measure/interleave.hpp"

#include <algorithm>
#include <utility>

#include "models/environment/random.hpp"

namespace cigsim {
namespace {

// Between the sorted values at the places around `share` of the way.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double rest = place - static_cast<double>(below);
  return sorted[below] * (1 - rest) + sorted[above] * rest;
}

}  // namespace

std::vector<std::size_t> interleaved(std::size_t count, std::size_t rounds, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::size_t> order;
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::size_t begin = order.size();
    for (std::size_t i = 0; i < count; ++i) order.push_back(i);
    for (std::size_t left = count; left > 1; --left)
      std::swap(order[begin + left - 1], order[begin + random.below(left)]);
  }
  return order;
}

Spread spread(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

nlohmann::ordered_json spread_json(const Spread& s) {
  return {{"median", s.median}, {"low", s.low}, {"high", s.high}};
}

}  // namespace cigsim
