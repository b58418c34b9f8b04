// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

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

// What the marks of a point say, few enough to tell them apart: the same in every plot.
struct Kind {
  const char* name;
  const char* colour;
  Mark mark;
};
constexpr Kind kKinds[] = {
    {"number", "#2f6fab", Mark::kDisc},        {"level", "#3c8f5c", Mark::kSquare},
    {"words", "#d1762b", Mark::kTriangle},     {"raster", "#8b5ea8", Mark::kDiamond},
    {"detail", "#1395a5", Mark::kPointedDown}, {"method", "#7a6a4f", Mark::kPentagon},
    {"together", "#3a3a3a", Mark::kCross}};

std::string kind_of(const TradeoffPoint& point) {
  if (point.knob == "default") return "number";
  for (const char* method : {"priority", "resolver", "retrieval", "coherence"})
    if (point.knob == method) return "method";
  for (const Kind& kind : kKinds)
    if (point.knob == kind.name) return point.knob;
  throw std::logic_error("no marks for the knob " + point.knob);
}

Curve marks_of(const Kind& kind) {
  Curve curve;
  curve.label = kind.name;
  curve.style = CurveStyle::kMarks;
  curve.colour = kind.colour;
  curve.mark = kind.mark;
  return curve;
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
  for (const Kind& kind : kKinds) {
    Curve curve = marks_of(kind);
    for (const TradeoffPoint* point : measured_points(t))
      if (kind_of(*point) == kind.name) curve.points.push_back(at(*point));
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
    const char* colour;
    Mark mark;
  };
  constexpr Field kFields[] = {
      // shades of the kind "words"
      {"coordinate_bits", &WordFormats::coordinate_bits, "#7f2f04", Mark::kDisc},
      {"direction_fraction", &WordFormats::direction_fraction, "#d1762b", Mark::kTriangle},
      {"quotient_fraction", &WordFormats::quotient_fraction, "#b3365b", Mark::kSquare},
      {"raster_fraction", &WordFormats::raster_fraction, "#c79a1b", Mark::kDiamond}};
  Plot plot;
  plot.title = "Machine words of other widths";
  plot.x_label = "bits";
  plot.y_label = "wrong elements, %";
  plot.log_y = true;
  for (const Field& field : kFields) {
    Curve curve;
    curve.label = field.name;
    curve.colour = field.colour;
    curve.mark = field.mark;
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

// A row a number and a level: they differ in little but time.
Plot rows_plot(const Tradeoff& t) {
  Plot plot;
  plot.title = "Numbers and levels: time and memory";
  plot.x_label = "ms a frame";
  plot.log_x = true;
  for (const Kind& kind : kKinds) {
    if (kind.name != std::string_view("number") && kind.name != std::string_view("level")) continue;
    Curve curve = marks_of(kind);
    for (const TradeoffPoint* p : measured_points(t)) {
      if (kind_of(*p) != kind.name) continue;
      const double ms = p->measured.frame_ms.median;
      curve.points.push_back({ms, static_cast<double>(plot.rows.size())});
      curve.names.push_back(
          fmt::format("{:.3g} ms, {:.1f} MiB", ms, p->measured.memory_mib.median));
      plot.rows.push_back(p->measured.setting.name);
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

Sheet tradeoff_sheet(const Tradeoff& t) {
  std::vector<Plot> plots;
  plots.push_back(cost_plot(t, "Time against wrong elements", "wrong elements, %", drawn_share));
  plots.back().curves.push_back(front_of(t));
  plots.back().notes = {"without a wrong element a mark stands where half a one would be"};
  plots.push_back(cost_plot(t, "Time against colour", "mean difference of colour, %",
                            [](const PictureError& e) { return e.mean_colour(); }));
  plots.back().notes = {"marks without a difference are left out"};
  plots.push_back(words_plot(t));
  plots.push_back(rows_plot(t));
  return {"tradeoff.svg", plot_script(plots, 2, kSize)};
}

}  // namespace cigsim
