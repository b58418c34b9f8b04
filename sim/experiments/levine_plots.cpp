// SPDX-License-Identifier: MIT
#include "sim/experiments/levine_plots.hpp"

#include <fmt/format.h>

#include <span>

#include "sim/drawing/plot.hpp"

namespace cigsim {
namespace {

// His groups are the first four distributions and the last four.
template <class Curve>
std::span<const Curve> group(const std::vector<Curve>& curves, int number) {
  return std::span(curves).subspan(number == 1 ? 0 : 4, 4);
}

std::string trend(std::string_view name, std::span<const Vec2> points) {
  const PowerFit fit = power_fit(points);
  return fit.points < 2 ? fmt::format("{}: no trend", name)
                        : fmt::format("{}: x^{:.2f}", name, fit.exponent);
}

Plot log_plot(std::string title) {
  Plot plot;
  plot.title = std::move(title);
  plot.x_label = "NPTS";
  plot.log_x = plot.log_y = true;
  return plot;
}

std::vector<Plot> hull_plots(std::span<const HullCurve> curves) {
  std::vector<Plot> plots;
  for (const NamedHullQuantity& q : kHullQuantities) {
    Plot plot = log_plot(q.letters);
    for (const HullCurve& curve : curves) {
      std::vector<Vec2> points = averages(curve, q.values);
      plot.notes.push_back(trend(name_of(curve.distribution), points));
      plot.curves.push_back({std::string(name_of(curve.distribution)), std::move(points)});
    }
    plots.push_back(std::move(plot));
  }
  return plots;
}

Plot histogram_plot(std::string title, std::string label, std::span<const double> values) {
  Plot plot;
  plot.title = std::move(title);
  plot.x_label = std::move(label);
  plot.y_label = "cases";
  plot.curves.push_back({"", histogram(values), CurveStyle::kBars});
  return plot;
}

std::vector<Plot> hull_histograms(const std::vector<HullCurve>& curves) {
  std::vector<Plot> plots;
  for (const HullCurve& curve : curves)
    for (const NamedHullQuantity& q :
         {kHullQuantities[0], kHullQuantities[3], kHullQuantities[4]}) {
      const HullDataSet& last = curve.sets.back();
      plots.push_back(
          histogram_plot(fmt::format("{} points, {}", last.points, name_of(curve.distribution)),
                         q.letters, last.*q.values));
    }
  return plots;
}

std::vector<Plot> sphere_plots(std::span<const SphereCurve> curves) {
  std::vector<Plot> plots;
  for (const NamedSphereQuantity& q : kSphereQuantities)
    for (const SphereCurve& curve : curves) {
      Plot plot = log_plot(fmt::format("{}, {}", q.letters, name_of(curve.distribution)));
      for (const double share : kSphereShares) {
        const std::string name = fmt::format("{:.0f} %", share * 100);
        std::vector<Vec2> points = percentiles(curve, q.values, share);
        plot.notes.push_back(trend(name, points));
        plot.curves.push_back({name, std::move(points)});
      }
      plots.push_back(std::move(plot));
    }
  return plots;
}

std::vector<Plot> sphere_histograms(const std::vector<SphereCurve>& curves) {
  std::vector<Plot> plots;
  for (const SphereCurve& curve : curves) {
    const SphereDataSet& last = curve.sets.back();
    const std::string title =
        fmt::format("{} points, {}", last.points, name_of(curve.distribution));
    plots.push_back(histogram_plot(title, "NSC", last.spheres_created));
    std::vector<double> selected;
    for (const auto* values : {&last.first, &last.second, &last.third, &last.fourth})
      selected.insert(selected.end(), values->begin(), values->end());
    plots.push_back(histogram_plot(title, "SP, all points", selected));
  }
  return plots;
}

template <class Value>
Plot edges_plot(const std::vector<HiddenLineDataSet>& sets, std::string title, Value value) {
  Plot plot;
  plot.title = std::move(title);
  plot.x_label = "edges";
  Curve cubes{"cubes", {}}, others{"16 rectangles, 32 random cubes", {}, CurveStyle::kMarks};
  for (const HiddenLineDataSet& set : sets)
    (set.cubes ? cubes : others).points.push_back({static_cast<double>(set.edges), value(set)});
  plot.curves = {std::move(cubes), std::move(others)};
  return plot;
}

std::vector<Plot> hidden_line_plots(const std::vector<HiddenLineDataSet>& sets) {
  using hidden_line::Counters;
  std::vector<Plot> plots;
  for (const NamedCounter& c : kHiddenLineCounters)
    plots.push_back(
        edges_plot(sets, c.letters, [&](const auto& s) { return average(s, c.value); }));
  plots.push_back(edges_plot(sets, "(AI/HL) / (IC/HL)", [](const auto& s) {
    return average(s, &Counters::actual_intersections) /
           average(s, &Counters::intersections_computed);
  }));
  plots.push_back(edges_plot(sets, "time, ms", [](const auto& s) { return average_ms(s); }));
  return plots;
}

std::vector<Plot> frame_plots(const HiddenLineDataSet& set) {
  std::vector<Plot> plots;
  for (const NamedCounter& c : kHiddenLineCounters) {
    Plot plot;
    plot.title = fmt::format("{}, {}", c.letters, set.name);
    plot.x_label = "degrees";
    for (const auto& [name, frames] :
         {std::pair{"yaw", &set.yaw}, std::pair{"pitch", &set.pitch}}) {
      Curve curve{name, {}, CurveStyle::kLine};
      const double step = 360.0 / static_cast<double>(frames->size());
      for (std::size_t f = 0; f < frames->size(); ++f)
        curve.points.push_back(
            {step * static_cast<double>(f), static_cast<double>((*frames)[f].counters.*c.value)});
      plot.curves.push_back(std::move(curve));
    }
    plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace

std::vector<Sheet> levine_sheets(const LevineResults& results) {
  std::vector<Sheet> sheets;
  const auto add = [&](const std::vector<Plot>& plots, int columns, const char* name) {
    sheets.push_back({name, plot_script(plots, columns)});
  };
  if (!results.hull.empty()) {
    add(hull_plots(group(results.hull, 1)), 2, "hull-group-1.svg");
    add(hull_plots(group(results.hull, 2)), 2, "hull-group-2.svg");
    add(hull_histograms(results.hull), 3, "hull-histograms.svg");
  }
  if (!results.sphere.empty()) {
    add(sphere_plots(group(results.sphere, 1)), 4, "sphere-group-1.svg");
    add(sphere_plots(group(results.sphere, 2)), 4, "sphere-group-2.svg");
    add(sphere_histograms(results.sphere), 2, "sphere-histograms.svg");
  }
  if (!results.hidden_line.empty()) {
    add(hidden_line_plots(results.hidden_line), 3, "hidden-line.svg");
    for (const HiddenLineDataSet& set : results.hidden_line)
      if (!set.cubes && set.objects == 16) add(frame_plots(set), 3, "hidden-line-city.svg");
  }
  return sheets;
}

}  // namespace cigsim
