// SPDX-License-Identifier: MIT
#include "sim/experiments/levine_findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cigsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using hidden_line::Counters;

template <class Curve>
const Curve& curve_of(const std::vector<Curve>& curves, PointDistribution distribution) {
  return *std::find_if(curves.begin(), curves.end(),
                       [&](const Curve& c) { return c.distribution == distribution; });
}

double hull_exponent(const HullCurve& curve, HullQuantity quantity) {
  return power_fit(averages(curve, quantity)).exponent;
}

// Averages over all eight distributions.
template <class Value>
double over_curves(const std::vector<HullCurve>& curves, Value value) {
  double sum = 0;
  for (const HullCurve& c : curves) sum += value(c);
  return sum / static_cast<double>(curves.size());
}

void add_hull(const std::vector<HullCurve>& curves, std::vector<Finding>& out) {
  const auto points = [&](PointDistribution d) {
    return hull_exponent(curve_of(curves, d), &HullDataSet::hull_points);
  };
  out.push_back({"hull points against points, cube 1: exponent", "0.29",
                 points(PointDistribution::kCube1), 0.27, 0.31});
  out.push_back({"hull points against points, cube 4: exponent", "0.20",
                 points(PointDistribution::kCube4), 0.18, 0.22});
  out.push_back({"NT/NPTH against points: exponent, average of eight", "about 0.75",
                 over_curves(curves,
                             [](const HullCurve& c) {
                               return hull_exponent(c, &HullDataSet::tests_per_point);
                             }),
                 0.70, 0.80});
  out.push_back({"NEQ/NPTH against points: exponent, average of eight", "1",
                 over_curves(curves,
                             [](const HullCurve& c) {
                               return hull_exponent(c, &HullDataSet::equivalent_per_point);
                             }),
                 0.95, 1.05});
  out.push_back({"NEQ/NT at the most points, average of eight", "about 10",
                 over_curves(curves,
                             [](const HullCurve& c) {
                               const HullDataSet& last = c.sets.back();
                               return mean(last.equivalent_tests) / mean(last.tests);
                             }),
                 7, 14});
}

double sphere_exponent(const std::vector<SphereCurve>& curves, PointDistribution d) {
  return power_fit(percentiles(curve_of(curves, d), &SphereDataSet::tests_per_point, 0.5)).exponent;
}

void add_sphere(const std::vector<SphereCurve>& curves, std::vector<Finding>& out) {
  using D = PointDistribution;
  struct Trend {
    D distribution;
    const char* words;
    double low, high;
  };
  for (const Trend& t :
       {Trend{D::kCube1, "a constant", -0.2, 0.2}, Trend{D::kCube2, "a constant", -0.2, 0.2},
        Trend{D::kCube4, "a constant", -0.2, 0.2}, Trend{D::kSphere1, "about linear", 0.75, 1.25},
        Trend{D::kSphere4, "nearly constant", -0.3, 0.3},
        Trend{D::kEllipse, "nearly constant", -0.3, 0.3}})
    out.push_back({"sphere, NT/NPTH against points, " + std::string(name_of(t.distribution)) +
                       ", 50 %: exponent",
                   t.words, sphere_exponent(curves, t.distribution), t.low, t.high});
  const SphereDataSet& worst = curve_of(curves, D::kSphere1).sets.back();
  // He has no curve for 60 % there, and one for 50 %.
  out.push_back({"sphere 1, 800 points: share without a sphere by point 26", "0.4",
                 static_cast<double>(worst.given_up) / static_cast<double>(worst.tests.size()), 0.4,
                 0.5});
  const SphereDataSet& ellipse = curve_of(curves, D::kEllipse).sets.back();
  out.push_back({"ellipse, 1600 points, 50 %: log10 of ESC", "7",
                 std::log10(percentile(ellipse.spheres_expected, 0.5)), 6.5, 7.5});
  out.push_back(
      {"ellipse, 1600 points, 50 %: NSC", "1", percentile(ellipse.spheres_created, 0.5), 1, 1});
  double first = 0;
  for (const Vec2& p : percentiles(curve_of(curves, D::kCube1), &SphereDataSet::first, 0.5))
    first = std::max(first, p.y);
  out.push_back({"cube 1, 50 %: first selected point, the worst of all sizes", "1", first, 1, 1});
}

void add_hidden_line(const std::vector<HiddenLineDataSet>& sets, std::vector<Finding>& out) {
  double least = kInfinity, most = 0, city = 0;
  std::vector<Vec2> times;
  for (const HiddenLineDataSet& set : sets) {
    const double share = average(set, &Counters::actual_intersections) /
                         average(set, &Counters::intersections_computed);
    least = std::min(least, share);
    most = std::max(most, share);
    if (set.cubes)
      times.push_back({static_cast<double>(set.edges), average_ms(set)});
    else if (set.objects == 16)
      city = average_ms(set);
  }
  out.push_back({"hidden lines, AI/IC, least of eight sets", "0.75 to 0.80", least, 0.745, 0.805});
  out.push_back({"hidden lines, AI/IC, most of eight sets", "0.75 to 0.80", most, 0.745, 0.805});
  out.push_back({"hidden lines, time against edges, cubes: correlation", "about linear",
                 line_fit(times).correlation, 0.95, 1, true});
  out.push_back({"hidden lines, 16 rectangles, 192 edges: ms", "130", city, 0, 33, true});
  out.push_back(
      {"hidden lines, 48 cubes, 576 edges: ms", "below 500", times.back().y, 0, 500, true});
}

}  // namespace

std::vector<Finding> levine_findings(const LevineResults& results) {
  std::vector<Finding> out;
  if (!results.hull.empty()) add_hull(results.hull, out);
  if (!results.sphere.empty()) add_sphere(results.sphere, out);
  if (!results.hidden_line.empty()) add_hidden_line(results.hidden_line, out);
  return out;
}

}  // namespace cigsim
