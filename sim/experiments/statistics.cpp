// SPDX-License-Identifier: MIT
#include "sim/experiments/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

struct Sums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  void add(double a, double b) {
    n += 1;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
    yy += b * b;
  }
  double spread_x() const { return n * xx - x * x; }
  double slope() const { return (n * xy - x * y) / spread_x(); }
};

}  // namespace

double mean(std::span<const double> values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const double place = std::ceil(share * static_cast<double>(values.size()) - 1e-9);
  const auto index = static_cast<std::ptrdiff_t>(std::max(place, 1.0)) - 1;
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

PowerFit power_fit(std::span<const Vec2> points, std::size_t last) {
  std::vector<Vec2> logs;
  for (const Vec2& p : points)
    if (p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y))
      logs.push_back({std::log10(p.x), std::log10(p.y)});
  if (logs.size() > last) logs.erase(logs.begin(), logs.end() - static_cast<std::ptrdiff_t>(last));
  Sums sums;
  for (const Vec2& p : logs) sums.add(p.x, p.y);
  PowerFit fit;
  fit.points = logs.size();
  if (logs.size() < 2 || sums.spread_x() <= 0) return fit;
  fit.exponent = sums.slope();
  fit.intercept = (sums.y - fit.exponent * sums.x) / sums.n;
  return fit;
}

LineFit line_fit(std::span<const Vec2> points) {
  Sums sums;
  for (const Vec2& p : points) sums.add(p.x, p.y);
  LineFit fit;
  if (points.size() < 2 || sums.spread_x() <= 0) return fit;
  fit.slope = sums.slope();
  fit.offset = (sums.y - fit.slope * sums.x) / sums.n;
  const double spread_y = sums.n * sums.yy - sums.y * sums.y;
  if (spread_y > 0)
    fit.correlation = (sums.n * sums.xy - sums.x * sums.y) / std::sqrt(sums.spread_x() * spread_y);
  return fit;
}

std::vector<Vec2> histogram(std::span<const double> values, std::size_t bins) {
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double v) { return std::isfinite(v); });
  if (finite.empty() || bins == 0) return {};
  const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
  const double range = *high - *low;
  const bool whole =
      std::all_of(finite.begin(), finite.end(), [](double v) { return v == std::floor(v); });
  double width = range > 0 ? range / static_cast<double>(bins) : 1;
  if (whole) width = std::max(1.0, std::ceil((range + 1) / static_cast<double>(bins)));
  const double first = whole ? *low - 0.5 : *low;
  std::vector<Vec2> classes;
  for (const double v : finite) {
    auto k = static_cast<std::size_t>((v - first) / width);
    if (!whole) k = std::min(k, bins - 1);
    while (classes.size() <= k)
      classes.push_back({first + width * (static_cast<double>(classes.size()) + 0.5), 0});
    classes[k].y += 1;
  }
  return classes;
}

}  // namespace cigsim
