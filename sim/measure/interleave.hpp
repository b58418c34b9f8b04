// SPDX-License-Identifier: MIT
// Rounds of measurements in random order, so that a drift of the computer (heat, other programs)
// falls on all alike; and what the rounds come to.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

namespace cigsim {

/// Which of `count` things to measure in which order: each once in every round, each round shuffled
/// anew. The same for the same seed on every computer.
std::vector<std::size_t> interleaved(std::size_t count, std::size_t rounds, std::uint64_t seed);

/// The middle of some values, and between which values the middle half of them lies (quartiles,
/// linear between neighbours). All 0 without values.
struct Spread {
  double median = 0, low = 0, high = 0;
  friend bool operator==(const Spread&, const Spread&) = default;
};
Spread spread(std::vector<double> values);

/// {"median", "low", "high"}
nlohmann::ordered_json spread_json(const Spread& spread);

}  // namespace cigsim
