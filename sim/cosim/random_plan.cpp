// SPDX-License-Identifier: MIT
#include "sim/cosim/random_plan.hpp"

#include <fmt/format.h>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/random.hpp"
#include "sim/functional_machine.hpp"

namespace cigsim::cosim {
namespace {

constexpr std::size_t kScenes = 12;
constexpr std::uint32_t kMostObjects = 24;

Database random_database(Random& random) {
  const auto& kinds = generate_kinds();
  // Levine's sets of cubes have numbers of their own.
  std::string_view kind = kinds[random.below(kinds.size())].name;
  GenerateOptions options{1 + random.below(kMostObjects), random.bits()};
  if (kind == "cubes") options.objects = random.below(2) == 0 ? 8 : 16;
  return prepare(generate_environment(kind, options));
}

// Somewhere in or around the scene, towards a part of it.
Viewpoint random_viewpoint(const Database& database, Random& random) {
  const Sphere& all = database.systems.front().sphere;
  const auto point = [&](double reach) {
    const double r = reach * std::max(all.radius, 1e-6);
    return all.centre + Vec3{random.between(-r, r), random.between(-r, r), random.between(-r, r)};
  };
  const Vec3 eye = point(random.below(3) == 0 ? 1 : 3), target = point(0.7);
  Viewpoint viewpoint;
  viewpoint.eye = eye == target ? Placement{eye, 0, 0, 0} : look_at(eye, target);
  viewpoint.eye.roll = random.below(2) == 0 ? 0 : random.between(-180, 180);
  viewpoint.fov = random.between(20, 100);
  return viewpoint;
}

}  // namespace

ComparePlan random_plan(std::uint32_t seed, OverloadPolicy policy, std::size_t frames,
                        const std::vector<Stage>& stages) {
  Random random(seed * std::uint64_t{3} + static_cast<std::uint64_t>(policy));
  ComparePlan plan;
  plan.name = fmt::format("random frames, policy {}", name_of(policy));
  for (std::size_t i = 0; i < kScenes; ++i)
    plan.databases.push_back(std::make_shared<Database>(random_database(random)));
  std::vector<FrameView> views;
  for (std::size_t f = 0; f < frames; ++f) {
    const std::size_t d = random.below(kScenes);
    views.push_back({random_viewpoint(*plan.databases[d], random), 0});
    plan.frames.push_back({d, views.back()});
  }
  plan.eye_reach = cigsim::eye_reach(views);
  MachineDescription& machine = plan.description = machine_preset("unlimited");
  machine.raster = {16 + static_cast<int>(random.below(80)),
                    16 + static_cast<int>(random.below(48))};
  machine.crossing_capacity = 2 + random.below(30);
  machine.edge_capacity = 40 + random.below(400);
  machine.object_capacity = random.below(2) == 0 ? 4 + random.below(20) : 0;
  machine.links = {1 + random.below(4), 1 + random.below(8), 1 + random.below(4),
                   1 + random.below(20), 1 + random.below(20)};
  plan.overload = policy;
  plan.stages = stages;
  plan.seed = seed;
  plan.stalls = random.bits();
  return plan;
}

}  // namespace cigsim::cosim
