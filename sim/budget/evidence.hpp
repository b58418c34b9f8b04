// SPDX-License-Identifier: MIT
// What was measured of the candidates, and which of them an error budget takes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/budget/budget.hpp"
#include "sim/measure/interleave.hpp"

namespace cigsim {

/// Of one candidate.
struct Evidence {
  std::string name;
  Spread frame_ms;
  ErrorFigures worst;         ///< of the worst of the sampled frames each
  double worst_distance = 0;  ///< PictureError::worst_distance
  bool measured = true;       ///< false: given up, it took too long
  friend bool operator==(const Evidence&, const Evidence&) = default;
};

nlohmann::ordered_json evidence_json(const Evidence& evidence);
/// The inverse. Throws nlohmann::json::exception.
Evidence evidence_from_json(const nlohmann::ordered_json& json);

/// The fastest that keeps the budget, by its place; none where nothing does.
std::optional<std::size_t> choose(const Budget& budget, const std::vector<Evidence>& all);

/// The fastest other one that keeps it, too.
std::optional<std::size_t> second(const Budget& budget, const std::vector<Evidence>& all,
                                  std::size_t chosen);

/// "0.02 % of the elements, 0 % of the colour, 0 % of the cycles": what the budget bounds, or all.
std::string errors_text(const Budget& budget, const ErrorFigures& errors);

/// For the message that nothing keeps the budget: those that miss it least, at most three.
std::string nearest_text(const Budget& budget, const std::vector<Evidence>& all);

}  // namespace cigsim
