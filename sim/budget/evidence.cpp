// SPDX-License-Identifier: MIT
#include "sim/budget/evidence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kNearest = 3;

std::optional<std::size_t> fastest(const Budget& budget, const std::vector<Evidence>& all,
                                   std::optional<std::size_t> but) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == but || !all[i].measured || !keeps(budget, all[i].worst)) continue;
    if (!best || all[i].frame_ms.median < all[*best].frame_ms.median) best = i;
  }
  return best;
}

// Bounds that are missed, all of them.
int missed(const Budget& budget, const ErrorFigures& e) {
  const bool exact = budget.kind == Budget::Kind::kExact;
  return (e.elements > budget.elements.value_or(exact ? 0 : 1)) +
         (e.colour > budget.colour.value_or(exact ? 0 : 1)) +
         (budget.cycles && !(e.cycles && *e.cycles <= *budget.cycles));
}

}  // namespace

Json evidence_json(const Evidence& e) {
  return {{"name", e.name},
          {"measured", e.measured},
          {"elements", e.worst.elements},
          {"worst_distance", e.worst_distance},
          {"colour", e.worst.colour},
          {"cycles", e.worst.cycles ? Json(*e.worst.cycles) : Json()},
          {"frame_ms", spread_json(e.frame_ms)}};
}

Evidence evidence_from_json(const Json& json) {
  Evidence e;
  json.at("name").get_to(e.name);
  json.at("measured").get_to(e.measured);
  json.at("elements").get_to(e.worst.elements);
  json.at("worst_distance").get_to(e.worst_distance);
  json.at("colour").get_to(e.worst.colour);
  if (!json.at("cycles").is_null()) e.worst.cycles = json.at("cycles").get<double>();
  const Json& ms = json.at("frame_ms");
  e.frame_ms = {ms.at("median").get<double>(), ms.at("low").get<double>(),
                ms.at("high").get<double>()};
  return e;
}

std::optional<std::size_t> choose(const Budget& budget, const std::vector<Evidence>& all) {
  return fastest(budget, all, {});
}

std::optional<std::size_t> second(const Budget& budget, const std::vector<Evidence>& all,
                                  std::size_t chosen) {
  return fastest(budget, all, chosen);
}

std::string errors_text(const Budget& budget, const ErrorFigures& errors) {
  const bool all = budget.kind != Budget::Kind::kShares;
  std::vector<std::string> parts;
  if (all || budget.elements) parts.push_back("elements " + percent_text(errors.elements));
  if (all || budget.colour) parts.push_back("colour " + percent_text(errors.colour));
  if (budget.cycles)
    parts.push_back("cycles " + (errors.cycles ? percent_text(*errors.cycles) : "not known"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string nearest_text(const Budget& budget, const std::vector<Evidence>& all) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].measured) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t i) {
      return std::tuple(missed(budget, all[i].worst), excess(budget, all[i].worst),
                        all[i].worst.elements, all[i].frame_ms.median);
    };
    return rank(a) < rank(b);
  });
  order.resize(std::min(order.size(), kNearest));
  std::vector<std::string> parts;
  for (const std::size_t i : order)
    parts.push_back(fmt::format("{} ({})", all[i].name, errors_text(budget, all[i].worst)));
  return parts.empty() ? "none could be measured" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace cigsim
