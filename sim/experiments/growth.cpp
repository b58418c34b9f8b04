// SPDX-License-Identifier: MIT
#include "sim/experiments/growth.hpp"

#include <algorithm>
#include <utility>

#include "sim/experiments/growth_sweeps.hpp"

namespace cigsim {

std::vector<Vec2> GrowthCurve::medians() const {
  std::vector<Vec2> out;
  for (const GrowthPoint& point : points) out.push_back({point.x, point.y.median});
  return out;
}

bool GrowthCurve::as_expected() const {
  const PowerFit found = fit();
  return found.points >= 2 && expected.low <= found.exponent && found.exponent <= expected.high;
}

bool GrowthCurve::holds() const { return timed || as_expected(); }

bool GrowthResults::good() const {
  return same_pictures &&
         std::all_of(curves.begin(), curves.end(), [](const GrowthCurve& c) { return c.holds(); });
}

GrowthResults run_growth(const GrowthOptions& options) {
  GrowthResults results;
  results.options = options;
  using Sweep = std::function<std::vector<GrowthCurve>()>;
  const std::pair<const char*, Sweep> sweeps[] = {
      {"planes", [&] { return grow_planes(options); }},
      {"edges", [&] { return grow_edges(options); }},
      {"raster", [&] { return grow_raster(options); }},
      {"objects in view", [&] { return grow_in_view(options); }},
      {"objects out of view", [&] { return grow_out_of_view(options, results.same_pictures); }}};
  double done = 0;
  for (const auto& [name, sweep] : sweeps) {
    if (options.progress) options.progress(done++ / std::size(sweeps), name);
    for (GrowthCurve& curve : sweep()) results.curves.push_back(std::move(curve));
  }
  return results;
}

}  // namespace cigsim
