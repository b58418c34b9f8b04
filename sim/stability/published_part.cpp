// SPDX-License-Identifier: MIT
// Stump's thresholds as `cigsim stability` tells them.
#include <fmt/format.h>

#include "sim/drawing/plot.hpp"
#include "sim/stability/parts.hpp"
#include "sim/stability/published_thresholds.hpp"

namespace cigsim::stability {
namespace {

using Json = nlohmann::ordered_json;

Json rows(const std::vector<ThresholdPoint>& points) {
  Json out = Json::array();
  for (const ThresholdPoint& p : points)
    out.push_back({{"axis", name_of(p.axis)},
                   {"value", p.value},
                   {"decks", p.decks},
                   {"refused", p.refused},
                   {"decisions", p.decisions},
                   {"wrong_sides", p.wrong_sides},
                   {"missed_cuts", p.missed_cuts},
                   {"false_cuts", p.false_cuts},
                   {"faces", p.faces},
                   {"own_cut", p.own_cut},
                   {"found", p.found},
                   {"right", p.right},
                   {"exact_found", p.exact_found},
                   {"exact_right", p.exact_right}});
  return out;
}

std::string share(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "-";
  return fmt::format("{:.1f}%", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string table(const std::vector<ThresholdPoint>& points) {
  std::string text = "Stump's thresholds: sides within 0.001, planes of the first three vertices\n";
  text += fmt::format("  {:<8}{:>8}{:>8}{:>12}{:>12}{:>12}{:>10}{:>9}{:>8}{:>14}\n", "axis",
                      "value", "refused", "wrong side", "missed cut", "false cut", "own cut",
                      "tables", "right", "exact, right");
  for (const ThresholdPoint& p : points)
    text += fmt::format("  {:<8}{:>8.0e}{:>8}{:>12}{:>12}{:>12}{:>10}{:>9}{:>8}{:>14}\n",
                        name_of(p.axis), p.value, p.refused, share(p.wrong_sides, p.decisions),
                        share(p.missed_cuts, p.decisions), share(p.false_cuts, p.decisions),
                        share(p.own_cut, p.faces), fmt::format("{}/{}", p.found, p.decks), p.right,
                        fmt::format("{}, {}", p.exact_found, p.exact_right));
  return text +
         "  scale: of all lengths; sliver: of the distance between a face's first three vertices\n";
}

std::vector<Plot> plots(const std::vector<ThresholdPoint>& points) {
  std::vector<Plot> out;
  for (const ThresholdAxis axis : {ThresholdAxis::kScale, ThresholdAxis::kSliver}) {
    Plot plot;
    plot.title = fmt::format("Stump's thresholds by {}", name_of(axis));
    plot.x_label = name_of(axis);
    plot.y_label = "share";
    plot.log_x = true;
    Curve wrong{"wrong decisions"}, own{"faces that cut their own object"};
    Curve tables{"wrong or no table"}, exact{"the same with exact sides"};
    for (const ThresholdPoint& p : points) {
      if (p.axis != axis) continue;
      const auto put = [&](Curve& curve, std::uint64_t part, std::uint64_t whole) {
        if (whole > 0)
          curve.points.push_back({p.value, static_cast<double>(part) / static_cast<double>(whole)});
      };
      put(wrong, p.wrong(), p.decisions);
      put(own, p.own_cut, p.faces);
      put(tables, p.decks - p.right, p.decks);
      put(exact, p.decks - p.exact_right, p.decks);
    }
    plot.curves = {std::move(wrong), std::move(own), std::move(tables), std::move(exact)};
    out.push_back(std::move(plot));
  }
  return out;
}

}  // namespace

WhyNot why_no_published(const Format&, bool) { return "it has formats of its own"; }

PartResult published_part(const PartOptions& options) {
  ThresholdOptions thresholds;
  thresholds.seed = options.seed;
  thresholds.progress = options.progress;
  const std::vector<ThresholdPoint> points = measure_thresholds(thresholds);
  return {"published",
          {{"decks", thresholds.decks}, {"objects", thresholds.objects}, {"rows", rows(points)}},
          table(points),
          {"published.svg", plot_script(plots(points), 2)}};
}

}  // namespace cigsim::stability
