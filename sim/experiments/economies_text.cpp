// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iterator>

#include "sim/drawing/plot.hpp"
#include "sim/experiments/economies_json.hpp"

namespace cigsim {
namespace {

// Shares of something, as a column.
std::string percent(double with, double without) {
  return without > 0 ? fmt::format("{:.1f} %", 100 * (1 - with / without)) : std::string("–");
}

std::string row(const EconomyResult& r) {
  std::string out = fmt::format("  {:<18}{:<14}{:<18}{:>9.3f}{:>9.3f}{:>10}{:>8.1f}{:>8.1f}",
                                r.economy.name, r.economy.with, r.economy.without,
                                r.with.frame_ms.median, r.without.frame_ms.median,
                                percent(r.with.frame_ms.median, r.without.frame_ms.median),
                                r.with.memory_mib.median, r.without.memory_mib.median);
  if (!r.holds())
    out += "  DIFFERS";
  else if (r.differing > 0)
    out += fmt::format("  {:.3g} % of the elements",
                       100.0 * static_cast<double>(r.differing) / static_cast<double>(r.elements));
  else
    out += "  the same";
  return out + "\n";
}

std::string work_of(const EconomyResult& r) {
  std::string out;
  for (const EconomyCount& c : r.counts)
    out += fmt::format("    {:<34}{:<16}{:>12}{:>12}{:>10}\n", r.economy.name, c.what, c.with,
                       c.without,
                       percent(static_cast<double>(c.with), static_cast<double>(c.without)));
  if (r.economy.stage) {
    std::string what(name_of(r.economy.stage->first));
    what += ", ms";
    out += fmt::format("    {:<24}{:<26}{:>12.4f}{:>12.4f}{:>10}\n", r.economy.name, what,
                       r.with.stage_ms.median, r.without.stage_ms.median,
                       percent(r.with.stage_ms.median, r.without.stage_ms.median));
  }
  return out;
}

std::string so_text(const SoSteps& so) {
  if (!so.why_not().empty()) return fmt::format("  SO matrix: none; {}\n", so.why_not());
  const auto frames = static_cast<double>(so.frames);
  const auto kept = static_cast<double>(so.update.cycles + so.row_cycles);
  return fmt::format(
      "  SO matrix, a frame   anew: {:.1f} cycles, {:.1f} pairs, {:.4f} ms; kept: {:.1f} cycles to "
      "update and {:.1f} to\n    read rows again, {:.1f} pairs, {:.1f} planes crossed, {:.4f} ms; "
      "saved {} of the cycles, {} of the time{}\n    Telling all planes when a group is first in "
      "view: {} cycles in all\n",
      static_cast<double>(so.full_cycles) / frames, static_cast<double>(so.pairs) / frames,
      so.full_ms.median, static_cast<double>(so.update.cycles) / frames,
      static_cast<double>(so.row_cycles) / frames, static_cast<double>(so.update.pairs) / frames,
      static_cast<double>(so.update.crossings) / frames, so.update_ms.median,
      percent(kept, static_cast<double>(so.full_cycles)),
      percent(so.update_ms.median, so.full_ms.median), so.wrong_rows > 0 ? "; ROWS DIFFER" : "",
      so.first.cycles);
}

std::string rtl_text(const RtlSize& rtl) {
  std::string out;
  for (const RtlSizeSide* side : {&rtl.sized, &rtl.fixed})
    out += fmt::format("  RTL {:<38} build {:>6.1f} s, library {:>6.2f} MiB, {:>8.3f} µs a row\n",
                       side->variant.name(), side->build_s, side->library_mib, side->row_us.median);
  if (!rtl.golden) out += "  RTL DIFFERS from the golden model\n";
  return out;
}

}  // namespace

std::string economies_text(const EconomyReport& report) {
  const EconomyScene& scene = report.economies.scene;
  std::string out =
      fmt::format("{}: {} objects, {} frames\n  {:<18}{:<14}{:<18}{:>9}{:>9}{:>10}{:>8}{:>8}  {}\n",
                  scene.name, scene.database->object_count, scene.views.size(), "economy", "with",
                  "without", "ms", "ms", "saved", "MiB", "MiB", "pictures");
  for (const EconomyResult& r : report.economies.results) out += row(r);
  out += "  Work over all frames, and time of the stage\n";
  for (const EconomyResult& r : report.economies.results) out += work_of(r);
  out += so_text(report.economies.so);
  if (report.rtl) out += rtl_text(*report.rtl);
  return out;
}

Sheet economies_sheet(const std::vector<EconomyReport>& reports) {
  std::vector<Plot> plots;
  for (const EconomyReport& report : reports) {
    Plot plot;
    plot.title = report.economies.scene.name;
    plot.x_label = "economy";
    plot.y_label = "time of a frame saved, %";
    Curve curve;
    curve.style = CurveStyle::kBars;
    double place = 1;
    for (const EconomyResult& r : report.economies.results) {
      plot.notes.push_back(fmt::format("{:.0f}: {}", place, r.economy.name));
      curve.points.push_back({place++, 100 * r.saved()});
    }
    plot.curves.push_back(std::move(curve));
    plots.push_back(std::move(plot));
  }
  return {"economies.svg", plot_script(plots, 2)};
}

}  // namespace cigsim
