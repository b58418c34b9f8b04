// SPDX-License-Identifier: MIT
// The cost of priority against the planes of a group, by both methods (growth_sweeps.hpp).
#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/priority_processor/functional.hpp"
#include "sim/experiments/growth_sweeps.hpp"
#include "sim/processor_time.hpp"

namespace cigsim {
namespace {

using priority_processor::Functional;
using priority_processor::Method;

// One group of boxes, all in view.
struct OneGroup {
  OneGroup(std::uint32_t members, std::uint64_t seed) {
    const Environment city = generate_environment("city", {members, seed});
    database = prepare(city);
    frame_calculator::Functional(database, 1, false)
        .compute({city.view->eye, city.view->fov}, {256, 256}, 0, active, moving);
  }
  PriorityList compute(Functional<double>& processor) const {
    PriorityList list;
    const PreparedSystem& system = database.systems[0];
    processor.compute(system.hierarchy, system.set, active, database.ground, list);
    return list;
  }

  Database database;
  ActiveEnvironment active;
  FaceSet moving;
};

// Microseconds of a list, over enough of them for the clock.
double list_us(const OneGroup& group, Functional<double>& processor, int lists) {
  ProcessorTime time;
  for (int i = 0; i < lists; ++i) group.compute(processor);
  return time.lap() * 1e3 / lists;
}

}  // namespace

std::vector<GrowthCurve> grow_planes(const GrowthOptions& options) {
  std::vector<OneGroup> groups;
  for (const std::uint32_t members : {5u, 9u, 17u, 33u, kGroupCapacity})
    groups.emplace_back(members, options.seed);
  const std::string sweep = "planes of a group";
  GrowthCurve counters{sweep,
                       "counters: a list, µs",
                       "planes_counters",
                       "1 for the side tests, and up to 2 for the pairs that they count",
                       true,
                       {1.2, 0.5, 2}};
  GrowthCurve matrix{
      sweep,
      "SO matrix: a list, µs",
      "planes_so_matrix",
      "2 for the pairs of members, each of them one question, and 1 for the marks of SEPL",
      true,
      {1.5, 0.8, 2.2}};
  GrowthCurve tested{sweep, "planes tested", "planes_tested", "1: each once", false, {1, 1, 1}};
  GrowthCurve pairs{sweep, "pairs of members", "planes_pairs", "2: n(n + 1)/2 of n + 1 members",
                    false, {2, 1.8, 2}};
  std::vector<std::vector<double>> by_counters(groups.size()), by_matrix(groups.size());
  Functional<double> count(Method::kCounters), ask(Method::kSoMatrix);
  const int lists = options.quick ? 20 : 2000;
  for (const std::size_t g : interleaved(groups.size(), options.quick ? 3 : 21, options.seed)) {
    by_counters[g].push_back(list_us(groups[g], count, lists));
    by_matrix[g].push_back(list_us(groups[g], ask, lists));
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].compute(count);
    const auto planes = static_cast<double>(groups[g].database.report.planes);
    const auto asked = static_cast<double>(count.work().tested_planes);
    const auto all = static_cast<double>(groups[g].database.report.pairs);
    counters.points.push_back({planes, spread(by_counters[g])});
    matrix.points.push_back({planes, spread(by_matrix[g])});
    tested.points.push_back({planes, {asked, asked, asked}});
    pairs.points.push_back({planes, {all, all, all}});
  }
  return {counters, matrix, tested, pairs};
}

}  // namespace cigsim
