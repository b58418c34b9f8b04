// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/tradeoff/tradeoff.hpp"

namespace cigsim {
namespace {

std::string percent(double share) {
  if (share == 0) return "0";
  return fmt::format("{:.3g} %", 100 * share);
}

std::string row(const TradeoffPoint& point, std::size_t names) {
  const Measured& m = point.measured;
  std::string line = fmt::format(
      "{}{}{} {:<10}{:<{}}", point.front ? "*" : " ", m.overload.overloaded > 0 ? "†" : " ",
      m.overload.saturated > 0 ? "‡" : " ", point.knob, m.setting.name, names);
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

// What capacities took, in words; empty without overload.
std::string losses(const OverloadSum& o) {
  if (o.overloaded == 0) return {};
  return fmt::format(
      "† overloaded in {} of {} frames: {} items, {} faces and {} crossings dropped, {} lines "
      "overfull",
      o.overloaded, o.frames, o.dropped_items, o.dropped_faces, o.dropped_crossings,
      o.overfull_lines);
}

std::string saturations(const OverloadSum& o) {
  if (o.saturated == 0) return {};
  return fmt::format("‡ words too narrow for their values in {} of {} frames: {} saturated",
                     o.saturated, o.frames, o.saturated_words);
}

// A line for all settings of which the same is to be said.
std::string overload_notes(const Tradeoff& t) {
  constexpr std::size_t kNamed = 3;
  std::string notes;
  for (const auto words_of : {losses, saturations}) {
    std::vector<std::pair<std::string, std::vector<std::string>>> lines;
    for (const TradeoffPoint& point : t.points) {
      const std::string words = words_of(point.measured.overload);
      if (words.empty()) continue;
      auto found = std::find_if(lines.begin(), lines.end(),
                                [&](const auto& line) { return line.first == words; });
      if (found == lines.end()) found = lines.insert(lines.end(), {words, {}});
      found->second.push_back(point.measured.setting.name);
    }
    for (const auto& [words, names] : lines) {
      const std::size_t named = std::min(kNamed, names.size());
      notes += fmt::format(
          "{} ({}", words,
          fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(named), "; "));
      if (names.size() > named) notes += fmt::format("; and {} more", names.size() - named);
      notes += ")\n";
    }
  }
  return notes;
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
  table += fmt::format("    {:<10}{:<{}}{:>10}{:>18}{:>10}{:>10}{:>9}{:>11}{:>10}{:>11}{:>9}\n",
                       "knob", "setting", names, "ms/frame", "quartiles", "frames/s", "Mcycle/s",
                       "MiB", "elements", "off edge", "colour", "cycles");
  for (const TradeoffPoint& point : t.points) table += row(point, names);
  table +=
      "\n* on the Pareto front of time and wrong elements: nothing else is as fast with as few\n"
      "elements: share that shows another object; off edge: how far the worst of them is from an\n"
      "edge, in elements; colour: mean difference; cycles: worst delay of a frame\n";
  table += overload_notes(t);
  for (const std::string& line : t.left_out) table += fmt::format("Left out  {}\n", line);
  for (const std::string& line : t.notes) table += fmt::format("Note      {}\n", line);
  return table;
}

}  // namespace cigsim
