// SPDX-License-Identifier: MIT
#include "sim/experiments/hull_experiment.hpp"

#include "models/database/hull/hull.hpp"
#include "sim/host_time.hpp"

namespace cigsim {
namespace {

void add_case(HullDataSet& set, PointDistribution distribution, std::uint64_t seed,
              std::uint32_t number) {
  const std::vector<Vec3> points = random_points(distribution, set.points, seed, number);
  HostTime time;
  const Hull hull = levine_hull(points);
  set.seconds += time.lap() / 1000;
  const auto hull_points = static_cast<double>(hull.vertices.size());
  const auto tests = static_cast<double>(hull.counters.tests);
  const auto equivalent =
      static_cast<double>(equivalent_tests(points.size(), hull.triangles.size()));
  set.hull_points.push_back(hull_points);
  set.tests.push_back(tests);
  set.equivalent_tests.push_back(equivalent);
  set.tests_per_point.push_back(tests / hull_points);
  set.equivalent_per_point.push_back(equivalent / hull_points);
}

}  // namespace

std::vector<HullCurve> run_hull_experiment(const ExperimentOptions& options) {
  double work = 0, done = 0;
  for (const PointDistribution d : kPointDistributions)
    for (const std::uint32_t n : published_sizes(d)) work += n;
  std::vector<HullCurve> curves;
  for (const PointDistribution d : kPointDistributions) {
    HullCurve curve{d, {}};
    for (const std::uint32_t n : published_sizes(d)) {
      HullDataSet& set = curve.sets.emplace_back();
      set.points = n;
      for (std::uint32_t c = 0; c < options.cases; ++c) {
        add_case(set, d, options.seed, c);
        if (options.progress) options.progress((done + double(n) * c / options.cases) / work);
      }
      done += n;
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<Vec2> averages(const HullCurve& curve, HullQuantity quantity) {
  std::vector<Vec2> out;
  for (const HullDataSet& set : curve.sets)
    out.push_back({static_cast<double>(set.points), mean(set.*quantity)});
  return out;
}

}  // namespace cigsim
