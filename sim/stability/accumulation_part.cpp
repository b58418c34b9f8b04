// SPDX-License-Identifier: MIT
// The accumulation of slopes as `cigsim stability` tells it.
#include <fmt/format.h>

#include "sim/drawing/plot.hpp"
#include "sim/stability/accumulation.hpp"
#include "sim/stability/parts.hpp"

namespace cigsim::stability {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kRasters[] = {4096, 8190};

Json rows(const std::vector<Accumulation>& results) {
  Json out = Json::array();
  for (const Accumulation& a : results)
    for (const AccumulationPoint& p : a.points)
      out.push_back({{"format", a.format.name},
                     {"raster", a.raster},
                     {"lines", p.lines},
                     {"worst", p.worst},
                     {"bound", p.bound},
                     {"held", p.held},
                     {"crossings", p.crossings},
                     {"wrong", p.wrong}});
  return out;
}

std::string table(const std::vector<Accumulation>& results) {
  std::string text = "Slopes: how far an edge goes astray, elements, after so many lines\n";
  text += fmt::format("  {:<19}{:>8}{:>8}{:>12}{:>12}{:>7}{:>19}\n", "format", "raster", "lines",
                      "worst", "bound", "held", "wrong elements");
  for (const Accumulation& a : results)
    for (const AccumulationPoint& p : a.points) {
      if (p.lines != 480 && p.lines != 1024 && p.lines < 4096) continue;
      text += fmt::format("  {:<19}{:>8}{:>8}{:>12.3g}{:>12.3g}{:>7}{:>19}\n", a.format.name,
                          a.raster, p.lines, p.worst, p.bound, p.held ? "yes" : "NO",
                          fmt::format("{} of {}", p.wrong, p.crossings));
    }
  return text;
}

std::vector<Plot> plots(const std::vector<Accumulation>& results) {
  std::vector<Plot> out;
  for (const int raster : kRasters) {
    Plot plot;
    plot.title = fmt::format("slopes over {} lines", raster);
    plot.x_label = "lines";
    plot.y_label = "elements astray, worst";
    plot.log_x = plot.log_y = true;
    for (const Accumulation& a : results) {
      if (a.raster != raster) continue;
      Curve worst{a.format.name, {}}, bound{a.format.name + ", bound", {}, CurveStyle::kBound};
      for (const AccumulationPoint& p : a.points) {
        worst.points.push_back({static_cast<double>(p.lines), p.worst});
        bound.points.push_back({static_cast<double>(p.lines), p.bound});
      }
      plot.curves.push_back(std::move(worst));
      plot.curves.push_back(std::move(bound));
    }
    out.push_back(std::move(plot));
  }
  return out;
}

}  // namespace

WhyNot why_no_accumulation(const Format& format, bool) {
  if (format.arithmetic == Arithmetic::kExact || format.arithmetic == Arithmetic::kCertified)
    return "its crossings are exact on every line";
  return {};
}

PartResult accumulation_part(const PartOptions& options) {
  std::vector<Accumulation> results;
  int trials = 0;
  for (const int raster : kRasters) {
    AccumulationOptions accumulation;
    accumulation.seed = options.seed;
    accumulation.lines = raster;
    accumulation.formats = options.formats.empty() ? usual_formats() : options.formats;
    std::erase_if(accumulation.formats,
                  [](const Format& f) { return why_no_accumulation(f, false).has_value(); });
    trials = accumulation.trials;
    for (Accumulation& result : measure_accumulation(accumulation))
      results.push_back(std::move(result));
    if (options.progress) options.progress(raster == kRasters[0] ? 0.4 : 1);
  }
  return {"accumulation",
          {{"trials", trials}, {"rows", rows(results)}},
          table(results),
          {"accumulation.svg", plot_script(plots(results), 2)}};
}

}  // namespace cigsim::stability
