// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "sim/tradeoff/tradeoff.hpp"

namespace cigsim {
namespace {

std::string percent(double share) {
  if (share == 0) return "0";
  return fmt::format("{:.3g} %", 100 * share);
}

std::string row(const TradeoffPoint& point, std::size_t names) {
  const Measured& m = point.measured;
  std::string line =
      fmt::format("{} {:<10}{:<{}}", point.front ? '*' : ' ', point.knob, m.setting.name, names);
  if (m.given_up) return line + "given up: " + *m.given_up + "\n";
  const PictureError error = m.error();
  line += fmt::format("{:>10.3f}{:>18}{:>10.4g}", m.frame_ms.median,
                      fmt::format("{:.3f}-{:.3f}", m.frame_ms.low, m.frame_ms.high),
                      m.frame_ms.median > 0 ? 1e3 / m.frame_ms.median : 0);
  line += m.delays.empty() ? fmt::format("{:>10}", "-")
                           : fmt::format("{:>10.3g}", m.mcycles_per_second.median);
  line += fmt::format("{:>9.1f}{:>11}{:>10.1f}{:>11}", m.memory_mib.median, percent(error.share()),
                      error.worst_distance, percent(error.mean_colour()));
  line += fmt::format("{:>9}\n", point.cycle_error ? percent(*point.cycle_error) : "-");
  return line;
}

}  // namespace

std::string tradeoff_table(const Tradeoff& t) {
  std::size_t names = 10;
  for (const TradeoffPoint& point : t.points)
    names = std::max(names, point.measured.setting.name.size() + 1);
  std::string table = fmt::format(
      "Trade-off {}: {} frame{} at {} x {}, {} round{} in random order (seed {})\n", t.scene,
      t.frames, t.frames == 1 ? "" : "s", t.range.raster.width, t.range.raster.height,
      t.options.rounds, t.options.rounds == 1 ? "" : "s", t.options.seed);
  table += "Errors    beside exact pictures of the most detailed descriptions";
  if (t.referee)
    table += fmt::format("; cycles beside {} of machine {}",
                         *t.referee == Level::kRtl ? "the RTL" : "the clocked level",
                         t.range.description.name);
  table += "\n\n";
  table += fmt::format("  {:<10}{:<{}}{:>10}{:>18}{:>10}{:>10}{:>9}{:>11}{:>10}{:>11}{:>9}\n",
                       "knob", "setting", names, "ms/frame", "quartiles", "frames/s", "Mcycle/s",
                       "MiB", "elements", "off edge", "colour", "cycles");
  for (const TradeoffPoint& point : t.points) table += row(point, names);
  table +=
      "\n* on the Pareto front of time and wrong elements: nothing else is as fast with as few\n"
      "elements: share that shows another object; off edge: how far the worst of them is from an\n"
      "edge, in elements; colour: mean difference; cycles: worst delay of a frame\n";
  for (const std::string& line : t.left_out) table += fmt::format("Left out  {}\n", line);
  return table;
}

}  // namespace cigsim
