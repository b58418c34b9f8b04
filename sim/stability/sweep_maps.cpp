// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/drawing/heat_map.hpp"
#include "sim/stability/stability_report.hpp"

namespace cigsim::stability {
namespace {

// One value has no map.
bool has_map(Axis axis) { return values_of(axis).size() > 1; }

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

bool has(const Decision& decision, Axis axis) {
  return std::find(decision.axes.begin(), decision.axes.end(), axis) != decision.axes.end();
}

std::size_t column_of(const Decision& decision, std::size_t format) {
  return decision.shared ? 0 : format;
}

HeatMap map_of(const SweepPlan& plan, const Sweep& sweep, std::size_t format, Axis axis) {
  HeatMap map;
  map.title = fmt::format("{}: share of wrong answers", plan.formats[format].name);
  map.x_label = fmt::format("{} ({})", name_of(axis), meaning_of(axis));
  for (const double value : values_of(axis)) map.columns.push_back(fmt::format("{:.3g}", value));
  for (std::size_t d = 0; d < plan.decisions.size(); ++d) {
    if (!has(plan.decisions[d], axis)) continue;
    map.rows.push_back(plan.decisions[d].name);
    for (const Cell& cell : sweep.cells)
      if (cell.decision == d && cell.axis == axis &&
          cell.format == column_of(plan.decisions[d], format))
        map.values.push_back(cell.posed == 0 ? kNothing
                                             : static_cast<double>(cell.wrong) /
                                                   static_cast<double>(cell.posed));
  }
  return map;
}

HeatMap overview(const SweepPlan& plan, const Sweep& sweep) {
  HeatMap map;
  map.title = "Share of wrong answers at the worst value of an axis";
  for (const Format& format : plan.formats) map.columns.push_back(format.name);
  for (std::size_t d = 0; d < plan.decisions.size(); ++d) {
    map.rows.push_back(plan.decisions[d].name);
    for (std::size_t f = 0; f < plan.formats.size(); ++f) {
      const Summary s = summary(sweep, d, column_of(plan.decisions[d], f));
      map.values.push_back(s.posed == 0 ? kNothing : s.worst_share());
    }
  }
  return map;
}

}  // namespace

std::vector<Sheet> sweep_maps(const SweepPlan& plan, const Sweep& sweep) {
  std::vector<Sheet> sheets{{"stability.svg", heat_map_script({overview(plan, sweep)}, 1)}};
  for (const Axis axis : plan.axes) {
    const bool any = std::any_of(plan.decisions.begin(), plan.decisions.end(),
                                 [&](const Decision& decision) { return has(decision, axis); });
    if (!any || !has_map(axis)) continue;
    std::vector<HeatMap> maps;
    for (std::size_t f = 0; f < plan.formats.size(); ++f)
      maps.push_back(map_of(plan, sweep, f, axis));
    sheets.push_back({fmt::format("stability-{}.svg", name_of(axis)), heat_map_script(maps, 2)});
  }
  return sheets;
}

}  // namespace cigsim::stability
