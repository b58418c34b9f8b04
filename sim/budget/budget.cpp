// SPDX-License-Identifier: MIT
#include "sim/budget/budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

constexpr const char* kForm =
    "none, 0, or shares such as elements=0.1%,cycles=0,colour=1% (any of the three)";

double parse_share(const std::string& what, const std::string& name, std::string text) {
  const bool percent = text.ends_with('%');
  if (percent) text.pop_back();
  double value = 0;
  if (!to_number(text, value) || value < 0 || value > (percent ? 100 : 1))
    throw UsageError(fmt::format("{}: {}={}{} must be a share from 0 to 1, or from 0% to 100%",
                                 what, name, text, percent ? "%" : ""));
  return percent ? value / 100 : value;
}

}  // namespace

Budget parse_budget(const std::string& what, const std::string& text) {
  Budget budget;
  budget.text = text;
  if (text == "none") return budget;
  if (text == "0") {
    budget.kind = Budget::Kind::kExact;
    return budget;
  }
  budget.kind = Budget::Kind::kShares;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos)
      throw UsageError(fmt::format("{}: '{}' must be {}", what, text, kForm));
    const std::string name = part.substr(0, equals);
    std::optional<double>* share = name == "elements" ? &budget.elements
                                   : name == "cycles" ? &budget.cycles
                                   : name == "colour" ? &budget.colour
                                                      : nullptr;
    if (share == nullptr) fail_on_choice(what, name, {"elements", "cycles", "colour"});
    if (*share) throw UsageError(fmt::format("{}: {} is named twice", what, name));
    *share = parse_share(what, name, part.substr(equals + 1));
  }
  return budget;
}

bool keeps(const Budget& budget, const ErrorFigures& errors) {
  switch (budget.kind) {
    case Budget::Kind::kNone:
      return true;
    case Budget::Kind::kExact:
      return errors.elements == 0 && errors.colour == 0;
    case Budget::Kind::kShares:
      break;
  }
  return errors.elements <= budget.elements.value_or(1) &&
         errors.colour <= budget.colour.value_or(1) &&
         (!budget.cycles || (errors.cycles && *errors.cycles <= *budget.cycles));
}

double excess(const Budget& budget, const ErrorFigures& errors) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto beyond = [](double error, double bound) {
    if (error <= bound) return 1.0;
    return bound > 0 ? error / bound : kInfinite;
  };
  if (budget.kind == Budget::Kind::kNone) return 1;
  const bool exact = budget.kind == Budget::Kind::kExact;
  double worst = std::max(beyond(errors.elements, budget.elements.value_or(exact ? 0 : 1)),
                          beyond(errors.colour, budget.colour.value_or(exact ? 0 : 1)));
  if (budget.cycles)
    worst = std::max(worst, errors.cycles ? beyond(*errors.cycles, *budget.cycles) : kInfinite);
  return worst;
}

std::string percent_text(double share) {
  return share == 0 ? "0" : fmt::format("{:.3g} %", 100 * share);
}

}  // namespace cigsim
