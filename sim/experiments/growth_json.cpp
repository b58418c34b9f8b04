// SPDX-License-Identifier: MIT
#include "sim/experiments/growth_json.hpp"

#include <fmt/format.h>

#include "sim/drawing/plot.hpp"
#include "sim/measure/host.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

// Without a fit: null.
Json exponent_json(const GrowthCurve& curve) {
  const PowerFit fit = curve.fit();
  return fit.points < 2 ? Json() : Json(fit.exponent);
}

Json curve_json(const GrowthCurve& curve) {
  Json sizes = Json::array(), values = Json::array();
  for (const GrowthPoint& point : curve.points) {
    sizes.push_back(point.x);
    values.push_back(curve.timed ? spread_json(point.y) : Json(point.y.median));
  }
  Json found{
      {"values", values}, {"exponent", exponent_json(curve)}, {"as_expected", curve.as_expected()}};
  Json out{{"key", curve.key},
           {"sweep", curve.sweep},
           {"quantity", curve.quantity},
           {"why", curve.why},
           {"expected",
            {{"exponent", curve.expected.exponent},
             {"low", curve.expected.low},
             {"high", curve.expected.high}}},
           {"sizes", sizes}};
  out[curve.timed ? "host" : "counted"] = found;
  return out;
}

}  // namespace

Json growth_json(const GrowthResults& results) {
  Json curves = Json::array();
  for (const GrowthCurve& curve : results.curves) curves.push_back(curve_json(curve));
  return {{"experiment", "growth"},
          {"seed", results.options.seed},
          {"quick", results.options.quick},
          {"most_objects", results.options.most_objects},
          {"versions", versions_json()},
          {"host", host_json()},
          {"same_pictures", results.same_pictures},
          {"good", results.good()},
          {"curves", curves}};
}

Sheet growth_sheet(const GrowthResults& results) {
  std::vector<Plot> plots;
  for (const GrowthCurve& curve : results.curves) {
    const PowerFit fit = curve.fit();
    Plot plot;
    plot.title = curve.quantity;
    plot.x_label = curve.sweep;
    plot.log_x = plot.log_y = true;
    plot.notes.push_back(fit.points < 2
                             ? std::string("no exponent")
                             : fmt::format("x^{:.2f}, expected {:.2f} to {:.2f}", fit.exponent,
                                           curve.expected.low, curve.expected.high));
    plot.curves.push_back({"", curve.medians()});
    plots.push_back(std::move(plot));
  }
  return {"growth.svg", plot_script(plots, 3)};
}

}  // namespace cigsim
