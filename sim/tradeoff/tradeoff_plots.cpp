// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/drawing/plot.hpp"
#include "sim/tradeoff/tradeoff.hpp"

namespace cigsim {
namespace {

constexpr PlotSize kSize{720, 540};
constexpr double kPercent = 100;

std::vector<const TradeoffPoint*> measured_points(const Tradeoff& t) {
  std::vector<const TradeoffPoint*> points;
  for (const TradeoffPoint& point : t.points)
    if (!point.measured.given_up) points.push_back(&point);
  return points;
}

// What the marks of a point say: few enough kinds to tell their colours apart.
std::string kind_of(const TradeoffPoint& point) {
  if (point.knob == "default") return "number";
  for (const char* method : {"priority", "resolver", "retrieval", "coherence"})
    if (point.knob == method) return "method";
  return point.knob;
}

std::vector<std::string> kinds(const Tradeoff& t) {
  std::vector<std::string> names;
  for (const TradeoffPoint& point : t.points)
    if (std::find(names.begin(), names.end(), kind_of(point)) == names.end())
      names.push_back(kind_of(point));
  return names;
}

// Time against an error.
template <class ErrorOf>
Plot cost_plot(const Tradeoff& t, const char* title, const char* y_label, ErrorOf error_of) {
  Plot plot;
  plot.title = title;
  plot.x_label = "ms a frame";
  plot.y_label = y_label;
  plot.log_x = plot.log_y = true;
  const auto at = [&](const TradeoffPoint& p) {
    return Vec2{p.measured.frame_ms.median, kPercent * error_of(p.measured.error())};
  };
  for (const std::string& kind : kinds(t)) {
    Curve curve;
    curve.label = kind;
    curve.style = CurveStyle::kMarks;
    for (const TradeoffPoint* point : measured_points(t))
      if (kind_of(*point) == kind) curve.points.push_back(at(*point));
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Curve front_of(const Tradeoff& t) {
  std::vector<const TradeoffPoint*> front = measured_points(t);
  std::erase_if(front, [](const TradeoffPoint* p) { return !p->front; });
  std::sort(front.begin(), front.end(), [](const TradeoffPoint* a, const TradeoffPoint* b) {
    return a->measured.frame_ms.median < b->measured.frame_ms.median;
  });
  Curve curve;
  curve.label = "Pareto front";
  curve.style = CurveStyle::kFront;
  for (const TradeoffPoint* p : front) {
    curve.points.push_back(
        {p->measured.frame_ms.median, kPercent * drawn_share(p->measured.error())});
    curve.names.push_back(p->measured.setting.name);
  }
  return curve;
}

Plot words_plot(const Tradeoff& t) {
  struct Field {
    const char* name;
    int WordFormats::*bits;
  };
  constexpr Field kFields[] = {{"coordinate_bits", &WordFormats::coordinate_bits},
                               {"direction_fraction", &WordFormats::direction_fraction},
                               {"quotient_fraction", &WordFormats::quotient_fraction},
                               {"raster_fraction", &WordFormats::raster_fraction}};
  Plot plot;
  plot.title = "Machine words of other widths";
  plot.x_label = "bits";
  plot.y_label = "wrong elements, %";
  plot.log_y = true;
  for (const Field& field : kFields) {
    Curve curve;
    curve.label = field.name;
    for (const TradeoffPoint* p : measured_points(t)) {
      const Setting& setting = p->measured.setting;
      if (setting.name != "machine" && !setting.name.starts_with(field.name)) continue;
      curve.points.push_back({static_cast<double>(setting.machine.description.formats.*field.bits),
                              kPercent * drawn_share(p->measured.error())});
    }
    std::sort(curve.points.begin(), curve.points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Plot memory_plot(const Tradeoff& t) {
  Plot plot;
  plot.title = "Levels";
  plot.x_label = "ms a frame";
  plot.y_label = "memory of the machine, MiB";
  plot.log_x = plot.log_y = true;
  for (const char* knob : {"number", "level"}) {
    Curve curve;
    curve.label = knob;
    curve.style = CurveStyle::kMarks;
    for (const TradeoffPoint* p : measured_points(t)) {
      // Names of whole machines; those of mixes would cover each other.
      const std::string& name = p->measured.setting.name;
      if (kind_of(*p) != knob || name.find('=') != std::string::npos) continue;
      curve.points.push_back({p->measured.frame_ms.median, p->measured.memory_mib.median});
      curve.names.push_back(name);
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

std::filesystem::path write_tradeoff_plots(const Tradeoff& t, const std::filesystem::path& folder) {
  std::vector<Plot> plots;
  plots.push_back(cost_plot(t, "Time against wrong elements", "wrong elements, %", drawn_share));
  plots.back().curves.push_back(front_of(t));
  plots.back().notes = {"without a wrong element a mark stands where half a one would be"};
  plots.push_back(cost_plot(t, "Time against colour", "mean difference of colour, %",
                            [](const PictureError& e) { return e.mean_colour(); }));
  plots.back().notes = {"marks without a difference are left out"};
  plots.push_back(words_plot(t));
  plots.push_back(memory_plot(t));
  const std::filesystem::path file = folder / "tradeoff.svg";
  write_plots(plots, 2, file, kSize);
  return file;
}

}  // namespace cigsim
