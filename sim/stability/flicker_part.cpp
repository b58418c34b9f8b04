// SPDX-License-Identifier: MIT
// Flicker as `cigsim stability` tells it.
#include <fmt/format.h>

#include <algorithm>

#include "sim/drawing/heat_map.hpp"
#include "sim/stability/flicker.hpp"
#include "sim/stability/parts.hpp"

namespace cigsim::stability {
namespace {

using Json = nlohmann::ordered_json;

Json rows(const std::vector<Flicker>& results) {
  Json out = Json::array();
  for (const Flicker& f : results)
    out.push_back({{"step", name_of(f.step)},
                   {"format", f.format.name},
                   {"pairs", f.pairs},
                   {"exact_changes", f.exact_changes},
                   {"flickering", f.flickering},
                   {"flickering_pairs", f.flickering_pairs},
                   {"worst", f.worst},
                   {"wrong", f.wrong}});
  return out;
}

std::string table(const std::vector<Flicker>& results) {
  std::string text =
      "Flicker: elements that change from frame to frame where the exact picture does not\n";
  text += fmt::format("  {:<9}{:<14}{:>8}{:>14}{:>12}{:>10}{:>12}{:>10}\n", "step of", "format",
                      "pairs", "exact changes", "flickering", "in pairs", "worst pair", "wrong");
  for (const Flicker& f : results)
    text += fmt::format("  {:<9}{:<14}{:>8}{:>14}{:>12}{:>10}{:>12}{:>10}\n", name_of(f.step),
                        f.format.name, f.pairs, f.exact_changes, f.flickering, f.flickering_pairs,
                        f.worst, f.wrong);
  return text + "  step: an ulp of a double, of a float, a coordinate word, or of a degree\n";
}

// Flickering elements a pair of frames, formats by steps.
HeatMap map(const std::vector<Flicker>& results) {
  HeatMap map;
  map.title = "flickering elements a pair of frames";
  map.x_label = "step";
  map.y_label = "format";
  const auto place = [](std::vector<std::string>& names, const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<std::size_t>(at - names.begin());
    if (at == names.end()) names.push_back(name);
    return index;
  };
  for (const Flicker& f : results) {
    place(map.columns, std::string(name_of(f.step)));
    place(map.rows, f.format.name);
  }
  map.values.resize(map.columns.size() * map.rows.size());
  map.high = 0;
  for (const Flicker& f : results) {
    const double value = static_cast<double>(f.flickering) /
                         static_cast<double>(std::max<std::uint64_t>(1, f.pairs));
    map.values[place(map.rows, f.format.name) * map.columns.size() +
               place(map.columns, std::string(name_of(f.step)))] = value;
    map.high = std::max(map.high, value);
  }
  if (map.high == 0) map.high = 1;
  return map;
}

}  // namespace

WhyNot why_no_flicker(const Format&, bool) { return {}; }

PartResult flicker_part(const PartOptions& options) {
  FlickerOptions flicker;
  flicker.seed = options.seed;
  flicker.formats = options.formats.empty() ? usual_formats() : options.formats;
  flicker.progress = options.progress;
  const std::vector<Flicker> results = measure_flicker(flicker);
  return {"flicker",
          {{"paths", flicker.paths}, {"frames", flicker.frames}, {"rows", rows(results)}},
          table(results),
          {"flicker.svg", heat_map_script({map(results)}, 1)}};
}

}  // namespace cigsim::stability
