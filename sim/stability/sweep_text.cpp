// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string>

#include "sim/stability/stability_report.hpp"

namespace cigsim::stability {
namespace {

constexpr int kColumn = 19;

// "6.4e6" instead of "6.4e+06".
std::string short_number(double value) {
  std::string text = fmt::format("{:.3g}", value);
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    const int exponent = std::stoi(text.substr(e + 1));
    text = fmt::format("{}e{}", text.substr(0, e), exponent);
  }
  return text;
}

// "47% near 10": the worst value; a point where nothing was wrong, a dash where nothing was posed.
std::string words(const Summary& s) {
  if (s.posed == 0) return "-";
  const char* broken = s.broken > 0 ? " !" : "";
  if (s.worst == nullptr) return fmt::format(".{}", broken);
  if (s.worst->axis == Axis::kMixed)
    return fmt::format("{:.0f}% mixed{}", 100 * s.worst_share(), broken);
  return fmt::format("{:.0f}% {} {}{}", 100 * s.worst_share(), name_of(s.worst->axis),
                     short_number(s.worst->value), broken);
}

std::string claim_line(const SweepPlan& plan, const Sweep& sweep, std::size_t d, std::size_t f) {
  const Decision& decision = plan.decisions[d];
  const Summary s = summary(sweep, d, f);
  if (s.broken == 0) return "";
  for (const Cell& cell : sweep.cells) {
    if (cell.decision != d || cell.format != f || !cell.first_broken) continue;
    const Outcome& outcome = cell.first_broken->outcome;
    return fmt::format(
        "  {} in {}: {} of {} beyond what is claimed; at {} {:g} {:.3g} {} where {:.3g} is "
        "claimed\n",
        decision.name, decision.shared ? "any format" : plan.formats[f].name, s.broken, s.claims,
        name_of(cell.axis), cell.value, *outcome.error, decision.unit, *outcome.bound);
  }
  return "";
}

}  // namespace

std::string sweep_text(const SweepPlan& plan, const Sweep& sweep) {
  std::string out = fmt::format(
      "Wrong answers at the worst value of an axis; . none; - not decided; {} instance{} a value, "
      "seed {}\n{:<16}",
      plan.trials, plan.trials == 1 ? "" : "s", plan.seed, "decision");
  for (const Format& format : plan.formats) out += fmt::format("{:<{}} ", format.name, kColumn - 1);
  while (out.back() == ' ') out.pop_back();
  std::string claims;
  std::uint64_t claimed = 0;
  for (std::size_t d = 0; d < plan.decisions.size(); ++d) {
    const bool shared = plan.decisions[d].shared;
    out += fmt::format("\n{:<16}", plan.decisions[d].name);
    for (std::size_t f = 0; f < (shared ? 1 : plan.formats.size()); ++f) {
      const Summary s = summary(sweep, d, f);
      claimed += s.claims;
      claims += claim_line(plan, sweep, d, f);
      out += shared ? fmt::format("{} in any format, {} of {} wrong", words(s), s.wrong, s.posed)
                    : fmt::format("{:<{}} ", words(s), kColumn - 1);
    }
    while (out.back() == ' ') out.pop_back();
  }
  out += claimed == 0 ? "\nClaims: none is made\n"
         : claims.empty()
             ? fmt::format("\nClaims: all {} held\n", claimed)
             : fmt::format("\nClaims that did not hold (!), of {}:\n{}", claimed, claims);
  return out + "First failure of each axis, with its instance: --json\n";
}

}  // namespace cigsim::stability
