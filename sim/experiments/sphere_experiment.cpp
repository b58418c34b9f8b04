// SPDX-License-Identifier: MIT
#include "sim/experiments/sphere_experiment.hpp"

#include <limits>

#include "models/database/hull/hull.hpp"
#include "models/database/sphere/sphere.hpp"
#include "sim/host_time.hpp"

namespace cigsim {
namespace {

void add_case(SphereDataSet& set, PointDistribution distribution, std::uint64_t seed,
              std::uint32_t number) {
  const std::vector<Vec3> points = random_points(distribution, set.points, seed, number);
  HostTime time;
  const LevineSphere result = levine_sphere(points, convex_hull(points));
  set.seconds += time.lap() / 1000;
  const bool found = result.sphere.has_value();
  const auto value = [&](double v) { return found ? v : std::numeric_limits<double>::infinity(); };
  const auto tests = static_cast<double>(result.tests);
  set.tests.push_back(value(tests));
  set.tests_per_point.push_back(value(tests / static_cast<double>(result.hull_points)));
  set.spheres_created.push_back(value(static_cast<double>(result.spheres_created)));
  set.spheres_tested.push_back(value(static_cast<double>(result.spheres_tested)));
  set.spheres_expected.push_back(result.spheres_expected);
  if (!found) {
    ++set.given_up;
    return;
  }
  constexpr SphereQuantity kSelected[] = {&SphereDataSet::first, &SphereDataSet::second,
                                          &SphereDataSet::third, &SphereDataSet::fourth};
  for (std::size_t k = 0; k < result.selected.size(); ++k)
    (set.*kSelected[k]).push_back(result.selected[k]);
  ++set.types[result.selected.size()];
}

}  // namespace

std::vector<SphereCurve> run_sphere_experiment(const ExperimentOptions& options) {
  std::size_t sets = 0, done = 0;
  for (const PointDistribution d : kPointDistributions) sets += published_sizes(d).size();
  std::vector<SphereCurve> curves;
  for (const PointDistribution d : kPointDistributions) {
    SphereCurve curve{d, {}};
    for (const std::uint32_t n : published_sizes(d)) {
      SphereDataSet& set = curve.sets.emplace_back();
      set.points = n;
      for (std::uint32_t c = 0; c < options.cases; ++c) {
        add_case(set, d, options.seed, c);
        if (options.progress)
          options.progress((static_cast<double>(done) + double(c) / options.cases) /
                           static_cast<double>(sets));
      }
      ++done;
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<Vec2> percentiles(const SphereCurve& curve, SphereQuantity quantity, double share) {
  std::vector<Vec2> out;
  for (const SphereDataSet& set : curve.sets)
    if (!(set.*quantity).empty())
      out.push_back({static_cast<double>(set.points), percentile(set.*quantity, share)});
  return out;
}

}  // namespace cigsim
