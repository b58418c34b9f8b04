// SPDX-License-Identifier: MIT
// Prepared worlds seen from two places that are clear of all planes, with their lists by exact
// planes.
#pragma once

#include <cmath>
#include <vector>

#include "models/database/prepare.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/machine/scale.hpp"
#include "models/priority_processor/functional.hpp"
#include "tests/levels/priority_bench.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {

inline bool clear_of_planes(const PriorityHierarchy& h, const Vec3& eye, int scale) {
  for (const Plane& plane : h.planes) {
    const Vec3 n = plane.normal, d = eye - plane.exact.p;
    const double distance = std::abs(dot(n, d)) / std::sqrt(dot(n, n));
    if (std::ldexp(distance, scale) < 16) return false;
  }
  return true;
}

struct PriorityWorldCase {
  PriorityCase bench;
  std::vector<PriorityList> expected;  ///< a bank

  explicit PriorityWorldCase(std::uint64_t seed) {
    Random random(seed);
    const World world = seed % 2 ? touching_world(random)
                                 : disjoint_world(random, 3 + static_cast<int>(random.below(40)));
    const Database database = prepare(world.environment);
    const PreparedSystem& system = database.systems[0];
    const int scale = coordinate_scale(database, bench.machine.formats);
    bench.memories.push_back(std::make_unique<priority_processor::PriorityMemory>(
        system.hierarchy, system.set.items.size(), scale, bench.machine));
    bench.pauses = seed % 3 == 0 ? 0 : seed;
    const frame_calculator::Functional calculator(database);
    while (bench.filled.size() < 2) {
      ActiveEnvironment active;
      FaceSet moving;
      calculator.compute(plain_viewpoint(world.environment, random), {64, 64}, 0, active, moving);
      std::uint64_t overflows = 0;
      const ViewWords view = view_words(active.view, scale, bench.machine.formats, overflows);
      if (overflows != 0 || !clear_of_planes(system.hierarchy, active.view.eye, scale)) continue;
      priority_processor::Functional<double> functional(priority_processor::Method::kCounters);
      functional.compute(system.hierarchy, system.set, active, database.ground,
                         expected.emplace_back());
      bench.filled.emplace_back(*bench.memories[0]);
      bench.filled.back().fill(active, view,
                               static_cast<std::uint32_t>(database.ground.items.size()));
    }
  }
};

}  // namespace cigsim::test
